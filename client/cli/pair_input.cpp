#include "client/cli/pair_input.h"

#include <utility>

#include "client/cli/npy_header.h"

namespace gonio::cli {

template <class T>
Result<std::unique_ptr<PairInput<T>>> open_pairs(InputKind what, const std::string& file,
                                                 bool degrees, bool keep_angles) {
  auto source = ByteSource::open(file);
  if (!source) return std::move(source).error();
  auto start = source->peek(kNpyMagic.size());
  if (!start) return start.error();
  if (*start == kNpyMagic) return open_npy<T>(what, std::move(source).value());
  return open_csv<T>(what, std::move(source).value(), degrees, keep_angles);
}

template Result<std::unique_ptr<PairInput<float>>> open_pairs(InputKind, const std::string&, bool,
                                                              bool);
template Result<std::unique_ptr<PairInput<double>>> open_pairs(InputKind, const std::string&, bool,
                                                               bool);

}  // namespace gonio::cli
