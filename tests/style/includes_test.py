#!/usr/bin/env python3
"""Each rule of includes.py reports an include that breaks it, and nothing else."""

import pathlib
import sys
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).parent))
import small_tree  # noqa: E402

# A small tree that keeps to the rules.
GOOD = {
    "src/include/gonio/base/result.h": "#pragma once\n#include <string>\n",
    "src/include/gonio/engine/material.h": '#include "gonio/base/result.h"\n',
    "src/base/text/number.h": '#include "gonio/base/result.h"\n',
    "src/numeric/number.h": "",
    "src/models/ggx.h": '#include "numeric/number.h"\n',
    "src/engine/kernels/kernel.h": '#include "models/ggx.h"\n#include "gonio/engine/material.h"\n',
    "src/fit/fit.h": '#include "engine/kernels/kernel.h"\n',
    "proto/wire/convert.h": '#include "gonio/v1/material.pb.h"\n#include "gonio/engine/material.h"\n',
    "server/server.h": '#include "fit/fit.h"\n#include "wire/convert.h"\n#include <grpcpp/server.h>\n',
    "client/client.cpp": '#include "wire/convert.h"\n#include "gonio/client/client.h"\n',
    "client/include/gonio/client/client.h": '#include "gonio/base/result.h"\n',
    "client/cli/main.cpp": '#include "server/server.h"\n#include "gonio/client/client.h"\n',
}


def check(changes):
    """The output and exit status of includes.py for the small tree with these files in addition or instead."""
    return small_tree.check("includes.py", {**GOOD, **changes})


class Includes(unittest.TestCase):
    def assert_reported(self, changes, *words):
        output, status = check(changes)
        self.assertEqual(status, 1, output)
        self.assertIn(" 1 not allowed", output)
        for word in words:
            self.assertIn(word, output)

    def test_passes_what_is_allowed(self):
        output, status = check({})
        self.assertEqual(status, 0, output)
        self.assertIn("12 files, 14 includes between them, 0 not allowed", output)

    def test_reports_an_arrow_that_points_up(self):
        for path, name in (("src/numeric/up.h", "models/ggx.h"), ("src/models/up.h", "engine/kernels/kernel.h"),
                           ("src/engine/truth/up.h", "fit/fit.h"), ("src/base/up.h", "numeric/number.h"),
                           ("proto/wire/up.cpp", "engine/kernels/kernel.h"), ("client/calls/up.cpp", "server/server.h"),
                           ("server/up.cpp", "gonio/client/client.h"), ("src/fit/up.cpp", "wire/convert.h")):
            with self.subTest(path):
                self.assert_reported({path: f'#include "{name}"\n'}, f"{path}:1: {name}: ", " may not include ")

    def test_reports_the_wire_and_logs_in_the_core(self):
        for name in ("<grpcpp/grpcpp.h>", "<google/protobuf/message.h>", "<spdlog/spdlog.h>", '"gonio/v1/material.pb.h"'):
            for path in ("src/fit/up.cpp", "client/include/gonio/client/up.h"):
                with self.subTest(name, path=path):
                    self.assert_reported({path: f"#pragma once\n#  include {name}\n"}, f"{path}:2: ", "must not know the wire")

    def test_reports_a_public_header_that_cannot_be_used(self):
        self.assert_reported({"src/include/gonio/base/up.h": '#include "base/text/number.h"\n'}, "one that is not installed")

    def test_reports_circles(self):
        self.assert_reported({"src/fit/a.h": '#include "fit/b.h"\n', "src/fit/b.h": '#include "fit/a.h"\n'},
                             "a circle of includes: ", "src/fit/a.h", " -> ", "src/fit/b.h")

    def test_reports_folders_that_include_each_other(self):
        self.assert_reported({"src/fit/up/a.h": '#include "fit/down/b.h"\n', "src/fit/down/b.h": "",
                              "src/fit/up/c.h": "", "src/fit/down/d.h": '#include "fit/up/c.h"\n'},
                             "src/fit/down/ and src/fit/up/ include each other")
        output, status = check({"src/fit/up/a.h": '#include "fit/fit.h"\n', "src/fit/b.cpp": '#include "fit/up/a.h"\n'})
        self.assertEqual(status, 0, output)

    def test_reports_what_it_does_not_know(self):
        self.assert_reported({"src/tables/a.h": ""}, "src/tables/a.h: its folder has no row")
        self.assert_reported({"src/fit/a.h": '#include "fit/lost.h"\n'}, "src/fit/a.h:1: fit/lost.h: no file")

    def test_fails_where_there_is_nothing(self):
        self.assertEqual(small_tree.check("includes.py", {})[1], 1)



if __name__ == "__main__":
    unittest.main()
