#include <string>
#include <utility>

#include "select/select.h"

namespace gonio::select {

Outcome check(const Options& options) {
  const auto size = [](std::size_t n) { return std::to_string(n); };
  if (options.lobes < 1 || options.lobes > 2)
    return bad_value("options.lobes", std::to_string(options.lobes), "1 or 2");
  if (options.starts < 1 || options.starts > 100)
    return bad_value("options.starts", size(options.starts), "1 to 100");
  const SetSizes& sizes = options.sizes;
  constexpr std::size_t kFewest = 100, kMost = 1'000'000;
  for (const auto& [name, n] : {std::pair{"fitted", sizes.fitted},
                                {"validation", sizes.validation},
                                {"certification", sizes.certification}}) {
    if (n < kFewest || n > kMost)
      return bad_value(std::string("options.sizes.") + name, size(n),
                       size(kFewest) + " to " + size(kMost));
  }
  return Ok{};
}

// The scene's bins, the draws of a material in float64, the sets, and their blocks.
std::size_t memory_of(int channels, const Scene& scene, const Options& options) {
  constexpr std::size_t kPair = 160, kValue = 28, kFits = std::size_t{16} << 20;
  constexpr std::size_t kBin = 512;  // and its message
  return kFits + kBin * scene.bins.size() +
         options.sizes.total() * (kPair + kValue * static_cast<std::size_t>(channels));
}

}  // namespace gonio::select
