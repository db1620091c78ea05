// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/input/parameter_tools.h>
#include <biface/program/parameters.h>

namespace Biface
{
  using namespace dealii;

  void
  Parameters::add_parameters(ParameterHandler               &prm,
                             const std::vector<std::string> &material_names,
                             const unsigned int              n_stages)
  {
    prm.enter_subsection("Surface");
    surface.add_parameters(prm);
    prm.leave_subsection();

    prm.enter_subsection("Mesh");
    mesh.add_parameters(prm);
    prm.leave_subsection();

    std::string names;
    for (const std::string &name : material_names)
      names += (names.empty() ? "" : ", ") + name;
    prm.declare_entry("Materials",
                      names,
                      Patterns::Anything(),
                      "Names of the materials, separated by commas. The "
                      "section 'Material NAME' describes each.");
    materials.resize(material_names.size());
    for (unsigned int i = 0; i < materials.size(); ++i)
      {
        materials[i].name = material_names[i];
        prm.enter_subsection("Material " + material_names[i]);
        materials[i].add_parameters(prm);
        prm.leave_subsection();
      }

    prm.enter_subsection("Laminate");
    laminate.add_parameters(prm);
    prm.leave_subsection();

    points.add_parameters(prm);

    prm.enter_subsection("Supports");
    supports.add_parameters(prm);
    prm.leave_subsection();

    prm.enter_subsection("Loads");
    pressure.add_parameters(prm);
    loads.add_parameters(prm);
    prm.leave_subsection();

    prm.enter_subsection("Contact");
    contact.add_parameters(prm);
    prm.leave_subsection();

    prm.declare_entry("Number of stages",
                      std::to_string(n_stages),
                      Patterns::Integer(1, 1000),
                      "How many sections 'Stage 1', 'Stage 2', ... there are. "
                      "Each goes on from the end of the one before it.");
    stages.resize(n_stages);
    for (unsigned int i = 0; i < n_stages; ++i)
      {
        prm.enter_subsection("Stage " + std::to_string(i + 1));
        stages[i].add_parameters(prm, i + 1);
        prm.leave_subsection();
      }

    prm.enter_subsection("Linear solver");
    linear_solver.add_parameters(prm);
    prm.leave_subsection();

    prm.enter_subsection("Newton");
    newton.add_parameters(prm);
    prm.leave_subsection();

    prm.enter_subsection("Step control");
    load_stepping.add_parameters(prm);
    prm.leave_subsection();

    prm.enter_subsection("Output");
    output.add_parameters(prm);
    prm.leave_subsection();

    prm.enter_subsection("Checkpoint");
    checkpoint.add_parameters(prm);
    prm.leave_subsection();
  }


  void
  Parameters::check() const
  {
    contact.check();
    newton.check();
    checkpoint.check();
    for (unsigned int i = 0; i < stages.size(); ++i)
      stages[i].check("Stage " + std::to_string(i + 1));
  }
} // namespace Biface
