// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_output_vtu_series_h
#define biface_output_vtu_series_h

#include <deal.II/base/data_out_base.h>

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


  /** Write the patches of all ranks to a VTU file. Must be called on all ranks.
   * Throws OutputError. */
  template <int dim>
  void
  write_vtu(VertexPatches<dim> &patches,
            const double        time,
            const std::string  &file,
            ResultsDirectory   &directory);


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


  /** A VTU file per step, and NAME.pvd, which lists all of them. */
  class VtuSeries : public ParaViewFiles
  {
  public:
    VtuSeries(const std::string    &series,
              const bool            wanted,
              ResultsDirectory     &directory,
              const ShellEquations &equations);

  protected:
    void
    cut_back() override;

    /** Write the file of a step, with the patches of all ranks. */
    template <int dim>
    void
    write_patches(VertexPatches<dim> &patches, const unsigned int step) const;

  private:
    /** Write the list of the files of all steps. */
    void
    write_record() const;

    std::string
    file_name(const unsigned int step) const;

    const std::string series;
  };
} // namespace Biface

#endif
