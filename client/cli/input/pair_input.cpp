#include "client/cli/input/pair_input.h"

#include <utility>

#include "client/cli/input/degrees_hint.h"
#include "client/cli/input/file_kind.h"
#include "client/cli/input/npy_header.h"

namespace gonio::cli {
namespace {

// As far as its beginning says.
bool holds_directions(FileKind kind) {
  return kind == FileKind::csv_pairs || kind == FileKind::csv_values || kind == FileKind::npy ||
         kind == FileKind::unknown;
}

}  // namespace

template <class T>
Result<std::unique_ptr<PairInput<T>>> open_pairs(InputKind what, const std::string& file,
                                                 bool degrees, bool keep_angles) {
  if (const auto kind = kind_of_file(file); kind && !holds_directions(*kind))
    return wrong_kind(argument_of(what), file, *kind, "directions");
  auto source = ByteSource::open(file);
  if (!source) return or_near_file(source.error(), file);
  auto start = source->peek(kNpyMagic.size());
  if (!start) return start.error();
  if (*start == kNpyMagic) return open_npy<T>(what, std::move(source).value());
  if (degrees) return open_csv<T>(what, std::move(source).value(), degrees, keep_angles);
  auto input = open_csv<T>(what, std::move(source).value(), degrees, true);
  if (!input) return input.error();
  return hinting_at_degrees<T>(std::move(*input), keep_angles);
}

template Result<std::unique_ptr<PairInput<float>>> open_pairs(InputKind, const std::string&, bool,
                                                              bool);
template Result<std::unique_ptr<PairInput<double>>> open_pairs(InputKind, const std::string&, bool,
                                                               bool);

}  // namespace gonio::cli
