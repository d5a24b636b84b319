// The consumer's own header of this name.
#pragma once
inline int mine_of_base_result() { return 1; }
