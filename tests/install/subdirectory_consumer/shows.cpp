#include <gonio/base/shown.h>
#include <gonio/base/version.h>

#include <cstdio>

int main() {
  std::printf("gonio %s: %s\n", gonio::kVersion, gonio::shown("a\tb").c_str());
  return gonio::shown("a\tb") == "a\\tb" ? 0 : 1;
}
