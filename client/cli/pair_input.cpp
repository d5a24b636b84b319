#include "client/cli/pair_input.h"

#include <utility>

#include "client/cli/npy_header.h"

namespace gonio::cli {

template <class T>
Result<std::unique_ptr<PairInput<T>>> open_pairs(const std::string& file, bool degrees,
                                                 bool keep_angles) {
  auto source = ByteSource::open(file);
  if (!source) return std::move(source).error();
  auto start = source->peek(kNpyMagic.size());
  if (!start) return start.error();
  if (*start == kNpyMagic) return open_npy<T>(std::move(source).value());
  return open_csv<T>(std::move(source).value(), degrees, keep_angles);
}

template Result<std::unique_ptr<PairInput<float>>> open_pairs(const std::string&, bool, bool);
template Result<std::unique_ptr<PairInput<double>>> open_pairs(const std::string&, bool, bool);

}  // namespace gonio::cli
