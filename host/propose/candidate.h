#pragma once
#include <string>

#include "propose/scene_proposal.h"

namespace morphgrid {

/// A box to design in, and the best design there.
struct Candidate {
  SightRating rating;
  int subdivisions = 0;
  double slope = 0;     ///< The steepest that the box may have.
  double share = 0;     ///< Of the mesh's area that lies in the box.
  MeshRequest surface;  ///< The mesh is turned, neither moved nor scaled.
  std::shared_ptr<const Target> target;
  DesignRequest design;
  DesignTrial trial;
};

/// "along -z, slopes up to 2, orthogonal net, 93 % of the surface".
std::string describe(const Candidate& candidate);

/// Whether it can be printed, and comes close as far as geometry tells.
bool isGood(const DesignTrial& trial);

/// The less, the closer it comes as far as geometry tells; infinite where there is no design.
double badness(const DesignTrial& trial);

/// What a trial found, in words.
std::string describe(const DesignTrial& trial);

/// The candidate on a mesh that is moved to the origin and scaled to what was asked for, in numbers
/// of few digits. Its trial is that of the candidate.
SceneProposal settle(const Candidate& candidate, const ProposalRequest& request);

}  // namespace morphgrid
