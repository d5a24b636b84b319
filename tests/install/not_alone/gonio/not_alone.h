// A header that does not include what it uses: the check of public headers must report it.
#pragma once

namespace gonio {

inline std::string not_alone() { return {}; }

}  // namespace gonio
