// A list of types, to loop over the models at compile time.
#pragma once

namespace gonio {

template <class... T>
struct TypeList {};

template <class... Lists>
struct ConcatenatedLists {
  using Type = TypeList<>;
};
template <class... T>
struct ConcatenatedLists<TypeList<T...>> {
  using Type = TypeList<T...>;
};
template <class... T, class... U, class... Lists>
struct ConcatenatedLists<TypeList<T...>, TypeList<U...>, Lists...> {
  using Type = typename ConcatenatedLists<TypeList<T..., U...>, Lists...>::Type;
};

// The lists one after the other as one list.
template <class... Lists>
using Concatenated = typename ConcatenatedLists<Lists...>::Type;

}  // namespace gonio
