#include "assess/verdict.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

namespace gonio::assess {
namespace {

constexpr double kRadians = std::numbers::pi / 180;
constexpr double kGain = 1e-3;  // by default

std::string text_of(double x) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%g", x);
  return text.data();
}

std::string name_of(const Incidence& at) {
  const std::string theta = text_of(at.theta / kRadians) + " deg";
  return at.phi == 0 ? theta : theta + ", phi " + text_of(at.phi / kRadians);
}

// The largest value of `of` over the elements, and where it is. NaN counts as the largest.
template <class Elements, class Of, class Name>
std::pair<double, std::string> largest(const Elements& elements, const Of& of, const Name& name) {
  std::pair<double, std::string> found{0, {}};
  for (const auto& element : elements) {
    const double value = of(element);
    if (value <= found.first || std::isnan(found.first)) continue;
    found = {value, std::string(name(element))};
  }
  return found;
}

class Judgement {
 public:
  Judgement(const Limits& limits, Report& report) : limits_(limits), report_(report) {}

  void judge_values() {
    at_places("improper", 0, [](const PlaceReport& p) {
      return static_cast<double>(p.fast.improper() + p.reference.improper());
    });
    at_places("stray", 0, [](const PlaceReport& p) {
      return static_cast<double>(p.fast.stray + p.reference.stray);
    });
    at_places("error_fast", limits_.error.value_or(report_.fast.relative),
              [](const PlaceReport& p) { return p.fast.worst.error; });
    at_places("error_reference", limits_.reference_error.value_or(report_.reference.relative),
              [](const PlaceReport& p) { return p.reference.worst.error; });
    at_places("reciprocity", limits_.reciprocity.value_or(2 * report_.fast.relative),
              [](const PlaceReport& p) { return p.reciprocity.error; });
  }

  void judge_energy() {
    judge_gain();
    from_angles("energy_loss", limits_.loss, [](const Incidence& at) {
      return 1 - *std::ranges::min_element(at.albedo) - at.unsure;
    });
  }

  void judge_table() {
    if (!report_.table) return;
    const TableReview& table = *report_.table;
    const auto add_finding = [&](std::string_view check, const CellFinding& found, double limit) {
      add(check, {found.value, found.where}, limit);
    };
    add_finding("missing", table.missing, limits_.missing);
    add_finding("missing_region", table.missing_region, limits_.missing_region);
    add_finding("zeros", table.zeros, limits_.zeros);
    add_finding("holes", table.holes, limits_.holes);
    add_finding("outlier", table.outlier, limits_.outlier);
    add_finding("extreme", table.extreme, limits_.extreme);
  }

  void judge_samples() {
    // Four roundings: of the weight, the pdf, their product and the cosine.
    constexpr double kRoundings = 4 * static_cast<double>(std::numeric_limits<float>::epsilon());
    from_angles("pdf_mass", limits_.mass,
                [](const Incidence& at) { return std::abs(at.mass + at.lost - 1) - at.unsure; });
    from_angles("weights", limits_.weight_error.value_or(report_.fast.relative + kRoundings),
                [](const Incidence& at) { return at.weight.error; });
    from_angles("sampled_albedo", limits_.deviation.value_or(most_deviation()),
                [](const Incidence& at) { return worst_of(at.deviation); });
    judge_distribution();
  }

 private:
  template <class Of>
  void at_places(std::string_view check, double limit, const Of& of) {
    add(check, largest(report_.places, of, [](const PlaceReport& p) { return p.name; }), limit);
  }
  template <class Of>
  void from_angles(std::string_view check, double limit, const Of& of) {
    add(check, largest(report_.incidences, of, name_of), limit);
  }
  void add(std::string_view check, std::pair<double, std::string> found, double limit) {
    report_.checks.push_back({std::string(check),
                              found.first,
                              limit,
                              found.first <= limit,
                              std::move(found.second),
                              {}});
  }

  void judge_gain() {
    const auto gain = [](const Incidence& at) {
      return *std::ranges::max_element(at.albedo) - 1 - at.unsure;
    };
    const auto is_uncut = [](const Incidence& at) { return at.theta < kUncut * kRadians; };
    if (limits_.gain || !report_.table) {
      from_angles("energy_gain", limits_.gain.value_or(kGain), gain);
      return;
    }
    std::vector<Incidence> uncut, cut;
    for (const Incidence& at : report_.incidences) (is_uncut(at) ? uncut : cut).push_back(at);
    add("energy_gain", largest(uncut, gain, name_of), kGain);
    const auto beyond = largest(cut, gain, name_of);
    if (beyond.first > kGain) {
      report_.checks.back().note = text_of(beyond.first) + " at " + beyond.second +
                                   ", where the horizon cuts the table's cells: not judged";
    }
  }

  // The only check with a lower limit.
  void judge_distribution() {
    Check check{"distribution", 1, limits_.probability.value_or(least_probability()), true, {}, {}};
    for (const Incidence& at : report_.incidences) {
      if (at.probability >= check.value) continue;
      check.value = at.probability;
      check.where = name_of(at);
    }
    check.passed = check.value >= check.limit;
    report_.checks.push_back(std::move(check));
  }

  static double worst_of(const std::vector<double>& values) {
    double most = 0;
    for (const double value : values) {
      if (std::isnan(value)) return value;
      most = std::max(most, value);
    }
    return most;
  }

  // Half of the allowed false alarms go to chi-square, half to the mean weights.
  [[nodiscard]] double least_probability() const {
    return kFalseAlarms / 2 /
           static_cast<double>(std::max<std::size_t>(1, report_.incidences.size()));
  }
  // Each of them has the probability 2 exp(-z^2 / 2).
  [[nodiscard]] double most_deviation() const {
    return std::sqrt(2 * std::log(2 * report_.channels / least_probability()));
  }

  const Limits& limits_;
  Report& report_;
};

Outcome check_limit(const char* field, const std::optional<double>& limit, double most) {
  if (!limit || (*limit >= 0 && *limit <= most)) return Ok{};
  return bad_value(std::string("limits.") + field, text_of(*limit), "0 to " + text_of(most));
}

}  // namespace

Outcome check_options(const Options& options) {
  constexpr double kAny = std::numeric_limits<double>::max();
  const Limits& l = options.limits;
  const std::initializer_list<std::tuple<const char*, std::optional<double>, double>> all{
      {"error", l.error, kAny},
      {"reference_error", l.reference_error, kAny},
      {"reciprocity", l.reciprocity, kAny},
      {"gain", l.gain, kAny},
      {"loss", l.loss, 1},
      {"mass", l.mass, kAny},
      {"weight_error", l.weight_error, kAny},
      {"probability", l.probability, 1},
      {"deviation", l.deviation, kAny},
      {"missing", l.missing, 1},
      {"missing_region", l.missing_region, 1},
      {"zeros", l.zeros, 1},
      {"holes", l.holes, 1},
      {"outlier", l.outlier, kAny},
      {"extreme", l.extreme, kAny}};
  for (const auto& [field, limit, most] : all) {
    if (auto checked = check_limit(field, limit, most); !checked) return checked;
  }
  if (options.pairs < 1 || options.pairs > kMostPairs) {
    return bad_value("pairs", std::to_string(options.pairs), "1 to " + std::to_string(kMostPairs));
  }
  return Ok{};
}

void set_verdict(const Limits& limits, Report& report) {
  report.checks.clear();
  Judgement judgement(limits, report);
  judgement.judge_values();
  judgement.judge_energy();
  judgement.judge_table();
  judgement.judge_samples();
  report.passed = std::ranges::all_of(report.checks, &Check::passed);
}

}  // namespace gonio::assess
