// A list of types, to loop over the models at compile time.
#pragma once

namespace gonio {
template <class... T>
struct TypeList {};
}  // namespace gonio
