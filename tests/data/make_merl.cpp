// Writes a material in the layout of the MERL database: make_merl OUT [NAME]
//
// NAME is one of $GONIO_DATA/merl/npf_names.txt; without it, the file holds a glossy example that
// needs no data.
#include <cstdio>
#include <filesystem>

#include "measured/npf_material.h"
#include "measured/synthetic_merl.h"

int main(int argc, char** argv) {
  if (argc < 2 || argc > 3) {
    std::fputs("usage: make_merl OUT [NAME]\n", stderr);
    return 2;
  }
  gonio::testing::IsotropicFunction function = gonio::testing::glossy_example;
  if (argc == 3) {
    const auto material = gonio::testing::NpfMaterial::load(argv[2]);
    if (!material) {
      const std::string folder = (gonio::testing::data_folder() / "merl").string();
      std::fprintf(stderr, "make_merl: no material '%s' in %s\n", argv[2], folder.c_str());
      return 1;
    }
    function = *material;
  }
  if (!gonio::testing::write_merl(argv[1], function)) {
    std::fprintf(stderr, "make_merl: cannot write %s\n", argv[1]);
    return 1;
  }
}
