// The consumer's own header of this name.
#pragma once
inline int mine_of_engine_evaluate() { return 1; }
