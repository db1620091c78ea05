// SPDX-License-Identifier: LGPL-2.1-or-later

// The layers of a wall contain its plies, or the parts of them that were asked
// for, in their places; the entry 'Laminate/Layers' is read or refused.

#include <biface/base/errors.h>
#include <biface/laminate/layup.h>

#include <cord_ply.h>
#include <tests.h>

using namespace Biface;

namespace
{
  void
  print(const std::string &layers, const std::string &plies)
  {
    Layup::Parameters parameters;
    parameters.plies     = parse_plies("plies", plies);
    parameters.layers    = parse_layers("layers", layers);
    parameters.reference = parse_thickness_position("reference", "middle");
    std::cout << "layers " << layers << " of " << plies << std::endl;
    try
      {
        for (const auto &layer : Layup(parameters, cord_ply()).layers(0, 0))
          {
            if (!layer)
              {
                std::cout << "  none" << std::endl;
                continue;
              }
            const auto heights = layer->face_heights();
            std::cout << "  from " << heights[0] << " to " << heights[1]
                      << ", plies";
            for (const Ply &ply : layer->get_plies())
              std::cout << ' ' << ply.number + 1 << ':' << ply.begin << '-'
                        << ply.end;
            std::cout << std::endl;
          }
      }
    catch (const InputError &error)
      {
        std::cout << "  " << error.what() << std::endl;
      }
  }


  void
  refuse(const std::string &layers)
  {
    try
      {
        parse_layers("Laminate/Layers", layers);
        check_true("refused: " + layers, false);
      }
    catch (const InputError &)
      {
        check_true("refused: " + layers, true);
      }
  }
} // namespace


int
main()
{
  const std::string plies = "cord: 1 @ 30, cord: 2 @ -30, cord: 3 @ 0";
  for (const char *layers : {"one",
                             "one per ply",
                             "2 per ply",
                             "2, 1",
                             "1, 3/2, 1/2",
                             "1/3, 1/3, 1/3, 2",
                             "2, 2"})
    print(layers, plies);
  print("2, 1", "cord: 1 @ 30, cord: 2 @ -30, cord: 3 @ 0 from 10 to 20");
  for (const char *layers :
       {"", "0", "-1, 4", "two per ply", "1.5 per ply", "101 per ply", "1;2"})
    refuse(layers);
}
