// The consumer's own header of this name.
#pragma once
inline int mine_of_client_client() { return 1; }
