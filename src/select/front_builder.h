// Decides, in ascending order of cost, which candidates are on the front and which is chosen.
#pragma once

#include "select/select.h"

namespace gonio::select {

// A fitted candidate with its errors.
struct FittedCandidate {
  Entry entry;
  MaterialSpec form;
  std::vector<std::string> parts;
  bool anisotropic = false;
  std::optional<Material> material;
  std::vector<Ratio> errors;  // on the second set, by block
};

class FrontBuilder {
 public:
  FrontBuilder(const Scene& scene, const Sets& sets);

  [[nodiscard]] const Blocks& validation() const { return validation_; }
  // Takes the next candidate, which has been fitted.
  void add(FittedCandidate candidate);
  [[nodiscard]] bool has_choice() const { return selection_.choice.has_value(); }
  Selection finish() &&;

 private:
  void place_on_front(FittedCandidate& candidate);
  void certify_error(FittedCandidate& candidate, std::size_t index);
  [[nodiscard]] Choice rounded_choice(const FittedCandidate& candidate, std::size_t index) const;

  const Scene& scene_;
  const Sets& sets_;
  Blocks validation_, certification_;
  Selection selection_;
  std::vector<Ratio> best_;  // of the front's last
  std::string best_name_;
  std::optional<FittedCandidate> nearest_;  // of those before the choice, the front's last
  std::size_t attempts_ = 0;
};

}  // namespace gonio::select
