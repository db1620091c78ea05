// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_controls_step_size_h
#define biface_stepping_controls_step_size_h

namespace Biface
{
  /** The size of steps, which is halved by a failure. */
  class StepSize
  {
  public:
    explicit StepSize(const double first = 0) : value(first)
    {}

    double
    get() const
    {
      return value;
    }

    /** Set the next size, by a growth factor and up to a maximum. */
    void
    succeeded(const double growth, const double maximum);

    /** Whether a failed step may be halved. */
    bool
    can_fail(const unsigned int max_cuts) const
    {
      return n_cuts < max_cuts;
    }

    /** Halve the size. */
    bool
    failed(const unsigned int max_cuts);

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &value &n_cuts;
    }

  private:
    double       value;
    unsigned int n_cuts = 0;
  };


  /** The growth factor of the step size from the iterations of the last step
   * and the desired number. */
  double
  step_growth(const double wanted, const unsigned int iterations);
} // namespace Biface

#endif
