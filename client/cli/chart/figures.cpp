#include "client/cli/chart/figures.h"

namespace gonio::cli {

std::vector<Figure> figures_of(const chart::Table& table) {
  if (table.name == "models") return {models_figure(table)};
  return {};
}

}  // namespace gonio::cli
