// How the bytes of a text are encoded. gonio reads UTF-8. Thread safety: a function without state.
#pragma once

#include <cstddef>
#include <string_view>

#include "gonio/base/result.h"

namespace gonio {

// As many bytes of a text as utf8_mark() looks at.
inline constexpr std::size_t kEncodingBytes = 4;

// How many bytes the byte-order mark takes with which `bytes` begin: 3, or 0 without one. `name` is
// what errors call the text. Errors: UTF-16 and UTF-32, told by their own marks or by their zeros.
Result<std::size_t> utf8_mark(std::string_view bytes, std::string_view name);

// All of a text without its byte-order mark. Errors as above.
Result<std::string_view> utf8_text(std::string_view bytes, std::string_view name);

}  // namespace gonio
