#pragma once
#include "design/grid_size.h"
#include "propose/scene_proposal.h"

namespace morphgrid {

/// Layers, nodes, layer spacing and cutoff for a surface (Eqs. 21 - 23): layers about a third of a
/// strut's length apart, less where the surface curves too strongly, but not so close that bars of
/// a fifth of it touch.
DesignRequest chooseDesign(const SurfaceSurvey& survey, const ProposalRequest& request,
                           NetKind net);

/// Whether a surface looks as if made of flat facets: hardly any curvature at most places, much at
/// a few.
bool looksFaceted(const SurfaceSurvey& survey);

/// The nearest spacing to the requested one at which the sheet's struts fit the material; nothing
/// where the layers would touch.
std::optional<double> fittingSpacing(const DesignTrial& trial, const SurfaceSurvey& survey,
                                     const DesignRequest& design);

MaterialRequest chooseMaterial(const ProposalRequest& request);

}  // namespace morphgrid
