// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_surface_imperfection_h
#define biface_surface_imperfection_h

#include <deal.II/base/function_lib.h>
#include <deal.II/base/point.h>

#include <mpi.h>

#include <memory>
#include <string>
#include <vector>

#include <biface/input/formula.h>
#include <biface/input/named_files.h>
#include <biface/surface/half_wave_series.h>
#include <biface/surface/reference_surface.h>

namespace Biface
{
  class EntryDeclarations;


  /**
   * The deviation of the stress-free shell from its reference surface, along
   * the outward normal: a formula of the position, of tables of measured
   * deviations or of the shapes in which the shell buckles, and of Fourier
   * series of measured shapes.
   */
  class Imperfection
  {
  public:
    /** A table of deviations: rows of both coordinates and a deviation. */
    struct Table
    {
      NamedFile                     file;
      std::vector<dealii::Point<3>> rows;
    };

    /** The Fourier series of a measured shape. */
    struct Series
    {
      NamedFile      file;
      HalfWaveSeries terms;
    };

    struct Parameters
    {
      /** The formula of the deviation; 0 if there is none. */
      std::string         formula = "0";
      std::vector<Table>  tables;
      std::vector<Series> series;

      void
      add_parameters(EntryDeclarations &prm);

      bool
      is_zero() const;

      /** Read tables and series. Must be called on all ranks. Throws
       * InputError. */
      void
      read_files(const MPI_Comm communicator);

      /** Check the formula, its tables and series. Throws InputError if the
       * formula uses what it does not know, or if a table or a series is not
       * used or not possible.
       * @param on_revolution whether the surface is one of revolution. */
      void
      check(const bool on_revolution) const;
    };

    /** The deviation from a surface, which is kept by reference. Throws
     * InputError if the rows of a table are not those of a grid, see
     * GridData, or if a series does not go on beyond the edges as the shell
     * does.
     * @param sector how that is. */
    Imperfection(const Parameters       &parameters,
                 const ReferenceSurface &surface,
                 const SectorOfShell    &sector);

    /** The deviation at a position with given coordinates. Throws InputError if
     * it is not a finite number. Unit: length. */
    double
    operator()(const dealii::Point<3> &x, const dealii::Point<2> &alpha) const;

  private:
    using Interpolation =
      dealii::Functions::InterpolatedTensorProductGridData<2>;

    /** A table as a function of the coordinates: bilinear between the rows,
     * constant beyond. */
    struct Chart
    {
      std::shared_ptr<const Interpolation> values;
      /** The first and the last row of the second coordinate. */
      double start, end;
    };

    const ReferenceSurface &surface;
    Formula                 formula;
    std::vector<Chart>      charts;
    std::vector<Series>     series;
    /** The period of the second coordinate in the user's unit; 0 for none. */
    double period;
  };
} // namespace Biface

#endif
