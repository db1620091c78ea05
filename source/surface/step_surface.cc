// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/config.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <biface/base/errors.h>
#include <biface/surface/known_surface.h>

#ifdef DEAL_II_WITH_OPENCASCADE
// faults in what it reads become exceptions
#  define OCC_CONVERT_SIGNALS
#  include <array>
#  include <csignal>

#  include <BRepBndLib.hxx>
#  include <BRepBuilderAPI_MakeVertex.hxx>
#  include <BRepExtrema_DistShapeShape.hxx>
#  include <BRep_Tool.hxx>
#  include <Bnd_Box.hxx>
#  include <GeomLProp_SLProps.hxx>
#  include <Message.hxx>
#  include <Message_Messenger.hxx>
#  include <Message_Printer.hxx>
#  include <OSD.hxx>
#  include <STEPControl_Reader.hxx>
#  include <ShapeAnalysis_Surface.hxx>
#  include <Standard_ErrorHandler.hxx>
#  include <Standard_Failure.hxx>
#  include <TopExp_Explorer.hxx>
#  include <TopoDS.hxx>
#  include <TopoDS_Face.hxx>
#  include <TopoDS_Shape.hxx>
#endif

namespace Biface
{
  using namespace dealii;

#ifdef DEAL_II_WITH_OPENCASCADE
  namespace
  {
    /** A face or an edge, and a box around it. */
    struct BoundedShape
    {
      explicit BoundedShape(const TopoDS_Shape &shape) : shape(shape)
      {
        BRepBndLib::Add(shape, box);
      }

      TopoDS_Shape shape;
      Bnd_Box      box;
    };


    std::vector<BoundedShape>
    parts_of(const TopoDS_Shape &whole, const TopAbs_ShapeEnum kind)
    {
      std::vector<BoundedShape> parts;
      for (TopExp_Explorer part(whole, kind); part.More(); part.Next())
        parts.emplace_back(part.Current());
      return parts;
    }


    gp_Pnt
    to_point(const Point<3> &x, const double unit)
    {
      return gp_Pnt(unit * x[0], unit * x[1], unit * x[2]);
    }


    /** The distance of a point from the closest one of a shape, and the latter;
     * infinite if none is found. */
    std::pair<double, gp_Pnt>
    closest_of(const TopoDS_Shape &shape, const gp_Pnt &x)
    {
      const BRepExtrema_DistShapeShape search(BRepBuilderAPI_MakeVertex(x),
                                              shape);
      if (!search.IsDone() || search.NbSolution() == 0)
        return {std::numeric_limits<double>::infinity(), gp_Pnt()};
      return {search.Value(), search.PointOnShape2(1)};
    }


    /** The same for all parts, of which those whose boxes are farther away
     * need not be searched. */
    std::pair<double, gp_Pnt>
    closest_of(const std::vector<BoundedShape> &parts, const gp_Pnt &x)
    {
      std::pair<double, gp_Pnt> closest{std::numeric_limits<double>::infinity(),
                                        gp_Pnt()};
      std::vector<std::pair<double, unsigned int>> by_distance;
      const Bnd_Box                                at(x, x);
      for (unsigned int i = 0; i < parts.size(); ++i)
        by_distance.emplace_back(parts[i].box.Distance(at), i);
      std::sort(by_distance.begin(), by_distance.end());
      for (const auto &[distance, i] : by_distance)
        {
          if (distance > closest.first)
            break;
          const auto here = closest_of(parts[i].shape, x);
          if (here.first < closest.first)
            closest = here;
        }
      return closest;
    }


    /** How far points of the mesh may be from where they should be. Unit: that
     * of @p size. */
    double
    tolerance(const double size)
    {
      return 1e-6 * size;
    }


    std::optional<Point<3>>
    to_mesh(const std::pair<double, gp_Pnt> &closest, const double unit)
    {
      if (!std::isfinite(closest.first))
        return {};
      return Point<3>(closest.second.X() / unit,
                      closest.second.Y() / unit,
                      closest.second.Z() / unit);
    }


    /** Keeps the handlers of signals that OpenCASCADE replaces. */
    class KeptSignals
    {
    public:
      KeptSignals()
      {
        for (unsigned int i = 0; i < signals.size(); ++i)
          sigaction(signals[i], nullptr, &handlers[i]);
      }

      ~KeptSignals()
      {
        for (unsigned int i = 0; i < signals.size(); ++i)
          sigaction(signals[i], &handlers[i], nullptr);
      }

      KeptSignals(const KeptSignals &) = delete;
      KeptSignals &
      operator=(const KeptSignals &) = delete;

    private:
      static constexpr std::array<int, 9> signals{{SIGSEGV,
                                                   SIGBUS,
                                                   SIGFPE,
                                                   SIGILL,
                                                   SIGSYS,
                                                   SIGHUP,
                                                   SIGINT,
                                                   SIGQUIT,
                                                   SIGTERM}};
      std::array<struct sigaction, 9>     handlers;
    };


    /** The shapes of the text of a file of STEP; null if it has none. A damaged
     * file can make the reader access memory that is not there. */
    TopoDS_Shape
    read_shapes(const std::string &text, const std::string &name)
    {
      const KeptSignals kept;
      OSD::SetSignal(OSD_SignalMode_Set, false);
      try
        {
          OCC_CATCH_SIGNALS
          std::istringstream stream(text);
          STEPControl_Reader reader;
          // in millimeters, whatever the unit of the file
          if (reader.ReadStream(name.c_str(), stream) == IFSelect_RetDone &&
              reader.TransferRoots() > 0)
            return reader.OneShape();
        }
      catch (const Standard_Failure &)
        {
          // as if there were none
        }
      return {};
    }


    class SurfaceOfStep : public KnownSurface
    {
    public:
      SurfaceOfStep(const TopoDS_Shape &whole, const double unit)
        : faces(parts_of(whole, TopAbs_FACE))
        , edges(parts_of(whole, TopAbs_EDGE))
        , unit(unit)
      {}

      std::optional<Point<3>>
      closest_point(const Point<3> &x, const double) const override
      {
        return to_mesh(closest_of(faces, to_point(x, unit)), unit);
      }

      std::optional<Point<3>>
      point_between(const Point<3>              &middle,
                    const std::vector<Point<3>> &others,
                    const double                 size) const override
      {
        // not on the other side of a wall
        std::vector<BoundedShape> here;
        for (const BoundedShape &face : faces)
          if (std::any_of(
                others.begin(), others.end(), [&](const Point<3> &other) {
                  return is_on(face, to_point(other, unit), size);
                }))
            here.push_back(face);
        const auto place =
          to_mesh(closest_of(here, to_point(middle, unit)), unit);
        if (!place)
          return {};
        // the closest point is beside the normal only where the surface ends
        constexpr double   largest = 0.02;
        const Tensor<1, 3> way     = *place - middle;
        const Tensor<1, 3> along   = normal_of(here, *place, way, size);
        double             length  = 0;
        for (const Point<3> &other : others)
          length = std::max(length, other.distance(middle));
        if ((way - (way * along) * along).norm() > largest * length)
          return {};
        return place;
      }

      std::optional<Point<3>>
      middle_of_edge(const Point<3> &a,
                     const Point<3> &b,
                     const double    size) const override
      {
        const Point<3>            middle = a + (b - a) / 2;
        std::pair<double, gp_Pnt> closest{
          std::numeric_limits<double>::infinity(), gp_Pnt()};
        for (const BoundedShape &edge : edges)
          {
            if (!is_on(edge, to_point(a, unit), size) ||
                !is_on(edge, to_point(b, unit), size))
              continue;
            const auto here = closest_of(edge.shape, to_point(middle, unit));
            if (here.first < closest.first)
              closest = here;
          }
        return std::isfinite(closest.first) ? to_mesh(closest, unit)
                                            : closest_point(middle, size);
      }

      Tensor<1, 3>
      normal(const Point<3>     &x,
             const Tensor<1, 3> &direction,
             const double        size) const override
      {
        return normal_of(faces, x, direction, size);
      }

    private:
      Tensor<1, 3>
      normal_of(const std::vector<BoundedShape> &some,
                const Point<3>                  &x,
                const Tensor<1, 3>              &direction,
                const double                     size) const
      {
        const gp_Pnt point = to_point(x, unit);
        const double near  = unit * tolerance(size);
        Tensor<1, 3> nearest;
        for (const BoundedShape &face : some)
          {
            if (!is_on(face, point, size))
              continue;
            const Handle(Geom_Surface) surface =
              BRep_Tool::Surface(TopoDS::Face(face.shape));
            const gp_Pnt2d at =
              ShapeAnalysis_Surface(surface).ValueOfUV(point, near);
            GeomLProp_SLProps local(surface, at.X(), at.Y(), 1, near);
            if (!local.IsNormalDefined())
              continue;
            const gp_Dir outward = local.Normal();
            Tensor<1, 3> here({outward.X(), outward.Y(), outward.Z()});
            if (here * direction < 0)
              here *= -1;
            if (here * direction > nearest * direction)
              nearest = here;
          }
        return nearest;
      }

      bool
      is_on(const BoundedShape &part, const gp_Pnt &x, const double size) const
      {
        const double near = unit * tolerance(size);
        return part.box.Distance(Bnd_Box(x, x)) <= near &&
               closest_of(part.shape, x).first <= near;
      }

      const std::vector<BoundedShape> faces, edges;
      /** That of the length of the mesh, in millimeters. */
      const double unit;
    };
  } // namespace
#endif


  std::shared_ptr<const KnownSurface>
  surface_of_step(const std::string &text,
                  const std::string &name,
                  const double       unit)
  {
#ifdef DEAL_II_WITH_OPENCASCADE
    Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer));
    const TopoDS_Shape whole = read_shapes(text, name);
    if (!whole.IsNull() && TopExp_Explorer(whole, TopAbs_FACE).More())
      return std::make_shared<const SurfaceOfStep>(whole, unit);
    throw InputError("the file '" + name +
                     "' of 'Surface/Mesh/Geometry file' must be one of STEP "
                     "with at least one face.");
#else
    (void) text;
    (void) unit;
    throw InputError("the file '" + name +
                     "' of 'Surface/Mesh/Geometry file' cannot be read: this "
                     "deal.II has no OpenCASCADE.");
#endif
  }
} // namespace Biface
