// What check_symbols.sh must find: beside the namespace's own symbol, a function template that the
// linker may share with objects compiled for other instruction sets.
namespace gonio::leaky {
int own = 1;
}

template <class T>
T leaked(T x) {
  return x + x;
}
template int leaked(int);
