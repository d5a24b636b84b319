#include <gonio/client/client.h>

#include "base/result.h"
#include "client/client.h"

extern "C" int connects() {
  const auto client = gonio::client::Client::connect("localhost:1");
  return client ? mine_of_base_result() + mine_of_client_client() : 0;
}
