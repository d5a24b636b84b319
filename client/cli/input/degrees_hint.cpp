#include "client/cli/input/degrees_hint.h"

#include <array>
#include <cmath>
#include <deque>
#include <numbers>
#include <string_view>
#include <utility>

#include "client/cli/output/numbers.h"
#include "client/cli/output/terminal.h"
#include "gonio/base/shown.h"

namespace gonio::cli {
namespace {

constexpr double kRounding = 1 + 1e-6;  // of pi in a file of few digits

void note(const std::string& what) {
  print_note("note: " + what + "; angles are in radians unless --deg is given");
}

// What is beyond an angle's range in radians; null: nothing.
const char* beyond(std::string_view name, double angle) {
  const bool theta = name.substr(0, 5) == "theta";
  const double most = theta ? std::numbers::pi / 2 : 2 * std::numbers::pi;
  if (!(std::abs(angle) > most * kRounding)) return nullptr;
  return theta ? "beyond pi/2" : "beyond 2 pi";
}

// What looks at angles as they pass, until one is beyond its range.
template <class T>
class HintingInput final : public PairInput<T> {
 public:
  HintingInput(std::unique_ptr<PairInput<T>> input, bool keep_angles)
      : input_(std::move(input)), names_(input_->columns()), keep_angles_(keep_angles) {}

  Result<std::size_t> read(std::span<T> wi, std::span<T> wo) override {
    auto pairs = input_->read(wi, wo);
    while (auto angles = input_->take_angles()) {
      look_at(*angles);
      if (keep_angles_) angles_.push_back(*angles);
    }
    return pairs;
  }
  [[nodiscard]] std::optional<std::uint64_t> total() const override { return input_->total(); }
  [[nodiscard]] std::optional<double> progress() const override { return input_->progress(); }
  [[nodiscard]] std::vector<std::string> columns() const override { return names_; }
  std::optional<std::array<double, 4>> take_angles() override {
    if (angles_.empty()) return std::nullopt;
    const auto angles = angles_.front();
    angles_.pop_front();
    return angles;
  }

 private:
  void look_at(const std::array<double, 4>& angles) {
    for (std::size_t i = 0; i < angles.size() && !noted_ && i < names_.size(); ++i) {
      const char* how = beyond(names_[i], angles[i]);
      if (how == nullptr) continue;
      note(names_[i] + " is " + shortest(angles[i]) + ", " + how);
      noted_ = true;
    }
  }

  std::unique_ptr<PairInput<T>> input_;
  std::vector<std::string> names_;
  std::deque<std::array<double, 4>> angles_;
  bool keep_angles_, noted_ = false;
};

}  // namespace

void hint_at_degrees(const GridSpec& grid) {
  for (std::size_t axis = 0; axis < grid.names.size(); ++axis) {
    for (const double angle : grid.given[axis]) {
      const char* how = beyond(grid.names[axis], angle);
      if (how != nullptr)
        return note("--grid " + grid.names[axis] + " has " + shortest(angle) + ", " + how);
    }
  }
}

void hint_at_degrees(const std::vector<float>& wi, const std::vector<float>& wo,
                     const std::string& file) {
  std::size_t below = 0;
  for (std::size_t z = 2; z < wi.size() && z < wo.size(); z += 3)
    below += wi[z] <= 0 || wo[z] <= 0 ? 1 : 0;
  const std::size_t pairs = wi.size() / 3;
  if (below == 0 || 4 * below < pairs) return;
  note(std::to_string(below) + " of " + std::to_string(pairs) + " pairs of " +
       shown(file, kQuotedLength) + " have a direction below the horizon");
}

template <class T>
std::unique_ptr<PairInput<T>> hinting_at_degrees(std::unique_ptr<PairInput<T>> input,
                                                 bool keep_angles) {
  return std::make_unique<HintingInput<T>>(std::move(input), keep_angles);
}

template std::unique_ptr<PairInput<float>> hinting_at_degrees(std::unique_ptr<PairInput<float>>,
                                                              bool);
template std::unique_ptr<PairInput<double>> hinting_at_degrees(std::unique_ptr<PairInput<double>>,
                                                               bool);

}  // namespace gonio::cli
