// The registry of the tests in this folder: every model of gonio, and one line more.
#include "models/list.h"
GONIO_MODEL(toy, Toy)
