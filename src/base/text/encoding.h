// How the bytes of a text are encoded. gonio reads UTF-8. Thread safety: a function without state.
#pragma once

#include <cstddef>
#include <string_view>

#include "gonio/base/result.h"

namespace gonio {

// The number of bytes of a text that utf8_mark() looks at.
inline constexpr std::size_t kEncodingBytes = 4;

// The length of the byte-order mark at the beginning of `bytes`: 3, or 0 where there is none.
// `name` stands for the text in errors. Errors: UTF-16 and UTF-32, recognised by their marks or by
// zero bytes.
Result<std::size_t> utf8_mark(std::string_view bytes, std::string_view name);

// A text without its byte-order mark. Errors as above.
Result<std::string_view> utf8_text(std::string_view bytes, std::string_view name);

}  // namespace gonio
