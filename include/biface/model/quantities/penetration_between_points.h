// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_quantities_penetration_between_points_h
#define biface_model_quantities_penetration_between_points_h


namespace Biface
{
  class ContactPair;
  struct Loads;
  struct State;


  /** How far a body is in the shell between the points that make contact. */
  struct PenetrationBetweenPoints
  {
    /** The depth beyond the mean of the depths of the points around, and its
     * ratio to the thickness of wall and tread; 0 outside the body. */
    double depth = 0, relative = 0;
  };

  /** The largest depth of a body: between nodes at the middle of cells and of
   * their sides, where the face bulges as its directors turn; between points in
   * cells at the corners of their parts of the cell, with the depth at the
   * points extrapolated linearly, and 0 if there is a single one in a cell.
   * Must be called on all ranks. */
  PenetrationBetweenPoints
  penetration_between_points(const ContactPair &pair,
                             const State       &state,
                             const Loads       &loads);
} // namespace Biface

#endif
