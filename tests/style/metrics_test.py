#!/usr/bin/env python3
"""metrics.py finds functions and their lines."""

import pathlib
import sys
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).parent))
import metrics  # noqa: E402

SOURCE = R'''#define BRACE {
namespace a {
struct Pair {
  double x{f(1)};  // not a function }
  int sum() const { return y; }
};
constexpr auto kText = R"(int f() { )";
const std::vector<int> kTable = {f(1), 2};
template <class T>
Result<T> read(const T& from,
               int count) {
  const auto each = [&](int i) {
    return "}";
  };
  if (count) {
    each('{');
  }
}
TEST(Reads, All) {
  read(1'000'000, 2);
}
}
'''


class Functions(unittest.TestCase):
    def test_are_found_with_their_lines(self):
        found = [(first, last, head.split("(")[0]) for first, last, head in metrics.functions_of(SOURCE)]
        self.assertEqual(found, [(5, 5, "int sum"), (9, 18, "template <class T> Result<T> read"), (19, 21, "TEST")])

    def test_percentiles_are_values(self):
        self.assertEqual([metrics.percentile([4, 1, 3, 2], part) for part in (0, 0.5, 0.9)], [1, 3, 4])


if __name__ == "__main__":
    unittest.main()
