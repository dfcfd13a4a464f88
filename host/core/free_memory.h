#pragma once

namespace morphgrid {

/// Gives the system back what was freed but is kept for later: to be called where something large
/// has gone and what follows needs less.
void returnFreedMemory();

}  // namespace morphgrid
