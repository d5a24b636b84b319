// Continuity: along paths through the hemispheres, a step that does not shrink with its interval is
// a jump.
#include <cmath>
#include <random>

#include "models/harness/findings.h"
#include "models/harness/harness.h"
#include "models/oracle/run.h"
#include "models/oracle/truth.h"

namespace gonio::testing {
namespace {

using Pair = DirectionPair<double>;

std::array<double, 3> between(const std::array<double, 3>& a, const std::array<double, 3>& b,
                              double t) {
  std::array<double, 3> w{};
  for (std::size_t c = 0; c < 3; ++c) w[c] = a[c] + t * (b[c] - a[c]);
  const double length = std::hypot(w[0], w[1], w[2]);
  for (double& component : w) component /= length;
  return w;
}

struct Path {
  Pair from, to;
  [[nodiscard]] Pair at(double t) const {
    return {between(from.wi, to.wi, t), between(from.wo, to.wo, t), from.kind};
  }
};

// Paths that cross the switches that are surfaces (equal cosines, right angles, clamps) by chance,
// and those that are points by design: h = n, wi = wo, wi = n.
std::vector<Path> paths() {
  auto pairs = hard_pairs<double>(21);
  std::erase_if(pairs, [](const Pair& p) {
    return std::min(p.wi[2], p.wo[2]) < 0.02 || p.kind == PairKind::off_unit;
  });
  std::shuffle(pairs.begin(), pairs.end(), std::mt19937_64(3));
  std::vector<Path> all;
  for (std::size_t i = 0; i < 60; ++i) {
    const Pair& a = pairs[2 * i];
    const Pair& b = pairs[2 * i + 1];
    all.push_back({a, b});
    const auto mirrored = [](const std::array<double, 3>& w) {
      return std::array<double, 3>{-w[0], -w[1], w[2]};
    };
    all.push_back({{a.wi, b.wo, a.kind}, {a.wi, between(b.wo, mirrored(a.wi), 2), a.kind}});
    all.push_back({{a.wi, b.wo, a.kind}, {a.wi, between(b.wo, a.wi, 2), a.kind}});
    all.push_back({{a.wi, b.wo, a.kind}, {mirrored(a.wi), b.wo, a.kind}});
  }
  std::erase_if(all, [](const Path& p) {
    const auto low = [](const Pair& q) { return std::min(q.wi[2], q.wo[2]) < 0.02; };
    return low(p.from) || low(p.to) || low(p.at(0.5));
  });
  return all;
}

struct Interval {
  std::size_t path;
  double from, to;
};

// The largest step of any channel between two neighbours, relative to the larger value.
double step(const std::vector<double>& f, std::size_t channels, std::size_t a, std::size_t b) {
  double most = 0;
  for (std::size_t c = 0; c < channels; ++c) {
    const double x = f[a * channels + c], y = f[b * channels + c];
    const double larger = std::max(x, y);
    // A root of a small number is steep, but no jump.
    if (larger > 1e-3) most = std::max(most, std::abs(x - y) / larger);
  }
  return most;
}

class Search {
 public:
  Search(const Subject& subject, const Draw& draw) : subject_(subject), draw_(draw) {}

  void run(const std::vector<Path>& all, Notes& notes) {
    std::vector<Interval> intervals;
    constexpr int kParts = 32;
    for (std::size_t p = 0; p < all.size(); ++p) {
      for (int i = 0; i < kParts; ++i)
        intervals.push_back({p, static_cast<double>(i) / kParts, (i + 1.0) / kParts});
    }
    // Half by half towards the larger step; what has none left is dropped.
    for (int depth = 0; depth < 52 && !intervals.empty(); ++depth) halve(all, intervals);
    if (intervals.empty()) return;
    const Interval& left = intervals.front();
    notes.add("jump, " + draw_.name, all[left.path].at(left.from), 0, left.from, left.to);
  }

 private:
  void halve(const std::vector<Path>& all, std::vector<Interval>& intervals) const {
    std::vector<Pair> pairs;
    for (const Interval& i : intervals) {
      for (const double t : {i.from, (i.from + i.to) / 2, i.to}) pairs.push_back(all[i.path].at(t));
    }
    const auto f = subject_.reference(draw_.spec, pairs, best_isa());
    const std::size_t channels = f.size() / pairs.size();
    std::vector<Interval> kept;
    for (std::size_t i = 0; i < intervals.size(); ++i) {
      const double first = step(f, channels, 3 * i, 3 * i + 1);
      const double second = step(f, channels, 3 * i + 1, 3 * i + 2);
      const auto [path, from, to] = intervals[i];
      if (std::max(first, second) < 2e-4) continue;  // a critical angle comes near this
      const double middle = (from + to) / 2;
      kept.push_back(first > second ? Interval{path, from, middle} : Interval{path, middle, to});
    }
    intervals = std::move(kept);
  }

  const Subject& subject_;
  const Draw& draw_;
};

}  // namespace

Findings check_continuity(const Subject& subject) {
  const std::vector<Path> all = paths();
  Notes notes;
  for (const Draw& draw : draws_of(subject.description)) {
    if (notes.full()) break;
    Search(subject, draw).run(all, notes);
  }
  return notes.findings();
}

}  // namespace gonio::testing
