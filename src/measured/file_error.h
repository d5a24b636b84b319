// What is wrong with a file of measurements, in one sentence. Thread safety: a function without
// state.
#pragma once

#include <string>
#include <string_view>

#include "gonio/base/result.h"

namespace gonio {

// "<where>: found <found>; expected <expected>". `where`, the file and perhaps a line, and `found`
// may hold any bytes: they are quoted as shown() quotes them (gonio/base/shown.h).
Error file_error(ErrorCode code, std::string_view where, std::string_view found,
                 std::string expected);

}  // namespace gonio
