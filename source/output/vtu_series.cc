// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>
#include <deal.II/grid/reference_cell.h>
#include <deal.II/numerics/data_component_interpretation.h>

#include <sstream>

#include <biface/output/csv.h>
#include <biface/output/vtu_series.h>

namespace Biface
{
  using namespace dealii;

  template <int dim>
  typename VertexPatches<dim>::Patch
  VertexPatches<dim>::new_patch() const
  {
    Patch patch;
    patch.patch_index    = patches.size();
    patch.n_subdivisions = 1;
    patch.reference_cell = ReferenceCells::get_hypercube<dim>();
    patch.data.reinit(names.size(), GeometryInfo<dim>::vertices_per_cell);
    return patch;
  }


  template <int dim>
  std::vector<
    std::tuple<unsigned int,
               unsigned int,
               std::string,
               DataComponentInterpretation::DataComponentInterpretation>>
  VertexPatches<dim>::get_nonscalar_data_ranges() const
  {
    std::vector<
      std::tuple<unsigned int,
                 unsigned int,
                 std::string,
                 DataComponentInterpretation::DataComponentInterpretation>>
      vectors;
    for (unsigned int i = 0; i + 2 < names.size(); ++i)
      if (names[i] == names[i + 2])
        vectors.emplace_back(
          i,
          i + 2,
          names[i],
          DataComponentInterpretation::component_is_part_of_vector);
    return vectors;
  }


  void
  ParaViewFiles::write_list(
    const std::string                                 &path,
    const std::vector<std::pair<double, std::string>> &times_and_names) const
  {
    std::ostringstream record;
    DataOutBase::write_pvd_record(record, times_and_names);
    write_text(path, record.str(), false, communicator);
  }


  VtuSeries::VtuSeries(const std::string    &series,
                       const bool            wanted,
                       ResultsDirectory     &directory,
                       const ShellEquations &equations)
    : ParaViewFiles(series + ".pvd", wanted, directory, equations)
    , series(series)
  {}


  void
  VtuSeries::cut_back()
  {
    if (!get_steps().empty())
      write_record();
  }


  template <int dim>
  std::string
  vtu_of_rank(VertexPatches<dim> &patches,
              const double        time,
              const Units        &units,
              const unsigned int  rank,
              const unsigned int  n_ranks)
  {
    DataOutBase::VtkFlags flags;
    flags.time              = time;
    flags.physical_units    = units.of_fields(patches.names);
    flags.compression_level = DataOutBase::VtkFlags::best_speed;
    patches.set_flags(flags);

    // one file for all ranks: only the first one has its head, only the last
    // one its end
    std::ostringstream stream;
    patches.write_vtu(stream);
    std::string       text    = stream.str();
    const std::string closing = "</Piece>\n";
    if (rank + 1 < n_ranks)
      text.erase(text.rfind(closing) + closing.size());
    if (rank > 0)
      text.erase(0, text.find("<Piece"));
    return text;
  }


  template <int dim>
  void
  VtuSeries::write_patches(std::unique_ptr<VertexPatches<dim>> patches,
                           const unsigned int                  step)
  {
    const unsigned int rank    = Utilities::MPI::this_mpi_process(communicator),
                       n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    // In a thread, without MPI; in complete_step() if there can be none, for
    // which std::async() copies the function once more.
    const auto write =
      [this,
       patches = std::shared_ptr<VertexPatches<dim>>(std::move(patches)),
       step,
       rank,
       n_ranks] {
        return vtu_of_rank(*patches, step, directory.units, rank, n_ranks);
      };
    text = std::async(write);
  }


  void
  VtuSeries::complete_step()
  {
    // on all ranks or on none
    if (!text.valid())
      return;
    // parallel files of MPI would also work, but do not report a full disk
    write_texts_of_ranks(
      directory.path(file_name(get_steps().back())), text.get(), communicator);
    write_record();
  }


  void
  VtuSeries::write_record() const
  {
    std::vector<std::pair<double, std::string>> times_and_names;
    for (const unsigned int step : get_steps())
      times_and_names.emplace_back(step, file_name(step));
    write_list(path(), times_and_names);
  }


  std::string
  VtuSeries::file_name(const unsigned int step) const
  {
    return series + "-" + Utilities::int_to_string(step, 4) + ".vtu";
  }


  template class VertexPatches<2>;
  template class VertexPatches<3>;

  template std::string
  vtu_of_rank(VertexPatches<2> &,
              const double,
              const Units &,
              const unsigned int,
              const unsigned int);

  template void
  VtuSeries::write_patches(std::unique_ptr<VertexPatches<2>>,
                           const unsigned int);
  template void
  VtuSeries::write_patches(std::unique_ptr<VertexPatches<3>>,
                           const unsigned int);
} // namespace Biface
