// Part (d) of a chart: what travels between client and server, and how fast. Thread safety: a
// function without state.
#pragma once

#include <string>

#include "chart/chart.h"
#include "chart/table.h"
#include "gonio/client/client.h"

namespace gonio::cli {

// Calls of several sizes and forms (pairs in float32 and float64, a grid; one call, and streams of
// chunks): time of a call, and of a pair. `connect` makes a client with its own size of chunks.
// Errors: what the server says.
Result<chart::Table> chart_wire(
    const std::function<Result<client::Client>(const client::ClientOptions&)>& connect,
    const std::string& transport, const chart::Options& options);

}  // namespace gonio::cli
