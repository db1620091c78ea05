// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_output_vtu_series_h
#define biface_output_vtu_series_h

#include <deal.II/base/data_out_base.h>

#include <future>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <biface/output/result_file.h>

namespace Biface
{
  /** Patches with data at their vertices, for deal.II's writers. */
  template <int dim>
  class VertexPatches : public dealii::DataOutInterface<dim, 3>
  {
  public:
    /** @param names the names of the data; the three components of a vector
     * have the same name. */
    explicit VertexPatches(const std::vector<std::string> &names) : names(names)
    {}

    const std::vector<std::string> names;

  protected:
    using Patch = dealii::DataOutBase::Patch<dim, 3>;

    /** A patch with its number and space for the data. */
    Patch
    new_patch() const;

    std::vector<Patch> patches;

  private:
    const std::vector<Patch> &
    get_patches() const override
    {
      return patches;
    }

    std::vector<std::string>
    get_dataset_names() const override
    {
      return names;
    }

    std::vector<std::tuple<
      unsigned int,
      unsigned int,
      std::string,
      dealii::DataComponentInterpretation::DataComponentInterpretation>>
    get_nonscalar_data_ranges() const override;
  };


  /** The part of a VTU file that a rank writes: its patches as a piece, after
   * the head of the file on the first rank, and before its end on the last. */
  template <int dim>
  std::string
  vtu_of_rank(VertexPatches<dim> &patches,
              const double        time,
              const Units        &units,
              const unsigned int  rank,
              const unsigned int  n_ranks);


  /** VTU files, and a PVD file that lists them for ParaView. */
  class ParaViewFiles : public ResultFile
  {
  public:
    /** @param list the name of the PVD file, see ResultFile. */
    ParaViewFiles(const std::string    &list,
                  const bool            wanted,
                  ResultsDirectory     &directory,
                  const ShellEquations &equations)
      : ResultFile(list, directory, equations), wanted(wanted)
    {}

    std::string
    description() const override
    {
      return name + " (for ParaView)";
    }

    bool
    is_wanted() const override
    {
      return wanted;
    }

  protected:
    /** Write a PVD file with the times and names of VTU files. */
    void
    write_list(
      const std::string                                 &path,
      const std::vector<std::pair<double, std::string>> &times_and_names) const;

  private:
    const bool wanted;
  };


  /** A VTU file per step, and NAME.pvd, which lists all of them. Most of the
   * time that a file takes is that of its compression, during which other files
   * are written. */
  class VtuSeries : public ParaViewFiles
  {
  public:
    VtuSeries(const std::string    &series,
              const bool            wanted,
              ResultsDirectory     &directory,
              const ShellEquations &equations);

    std::string
    names_of_files() const override
    {
      return series + "(?:\\.pvd|-([0-9]{4,})\\.vtu)";
    }

  protected:
    void
    cut_back() override;

    /** Write the file of a step, with the patches of all ranks, until
     * complete_step(). */
    template <int dim>
    void
    write_patches(std::unique_ptr<VertexPatches<dim>> patches,
                  const unsigned int                  step);

  private:
    void
    complete_step() override;

    /** Write the list of the files of all steps. */
    void
    write_record() const;

    std::string
    file_name(const unsigned int step) const;

    const std::string series;
    /** The part of the file of the last step that this rank writes, until it is
     * written. */
    std::future<std::string> text;
  };
} // namespace Biface

#endif
