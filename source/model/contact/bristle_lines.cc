// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/lac/full_matrix.h>

#include <cmath>

#include <biface/base/gather.h>
#include <biface/model/contact/bristle_lines.h>
#include <biface/model/state/load_rates.h>
#include <biface/model/state/placed_body.h>
#include <biface/model/state/rolling_step.h>
#include <biface/model/state/state.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** The mean motion between two.
     * @param angular_velocity_is_given otherwise it is that at the end. */
    Rolling
    mean_motion(const Rolling &start,
                const Rolling &end,
                const bool     angular_velocity_is_given)
    {
      Rolling mean = end;
      mean.ground.velocity =
        (start.ground.at(end.ground.point) + end.ground.velocity) / 2;
      mean.ground.spin = (start.ground.spin + end.ground.spin) / 2;
      if (angular_velocity_is_given)
        mean.angular_velocity =
          (start.angular_velocity + end.angular_velocity) / 2;
      return mean;
    }
  } // namespace


  BristleLines::BristleLines(const ShellMesh       &mesh,
                             const Streamlines     &streamlines,
                             const Resultants::Face face,
                             const unsigned int     number,
                             const State           &state,
                             const ContactState    &zone,
                             const PlacedBody      *body,
                             const Rolling         *rolling)
    : mesh(mesh)
    , face(face)
    , body(body)
    , law(body && rolling ? body->laws.bristles() : nullptr)
    , step(state.rolling_step.get())
    , halfway(state.step && state.rolling_step)
    , number(number)
  {
    if (!exist())
      return;
    places.resize(mesh.nodes.size());
    // a bristle depends on all nodes that its particle has passed, on whatever
    // rank, so that each rank has the whole footprint
    std::map<unsigned int, std::map<unsigned int, LineNode>> by_line;
    for (const std::vector<LineNode> &of_rank :
         gather_on_all(mesh.communicator, own_nodes(streamlines, state, zone)))
      for (const LineNode &node : of_rank)
        {
          auto      &of_line  = by_line[node.line];
          const auto inserted = of_line.insert({node.place, node});
          LineNode  &known    = inserted.first->second;
          if (inserted.second)
            continue;
          // a node at the border is sent by several ranks, each with the area
          // of its own cells; only its owner knows its unknowns
          const double area = known.area + node.area;
          if (node.owned)
            known = node;
          known.area = area;
        }
    const Rolling over_step =
      (step ? mean_motion(
                *step->loads.rolling, *rolling, step->angular_velocity_is_given)
            : *rolling);
    for (const auto &line : by_line)
      append_lines(line.second, over_step);

    std::map<types::global_cell_index, unsigned int> own;
    for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
      own[mesh.nodes[n].number] = n;
    for (unsigned int l = 0; l < lines.size(); ++l)
      for (unsigned int j = 0; j < lines[l].nodes.size(); ++j)
        {
          const auto node = own.find(lines[l].nodes[j].number);
          if (node != own.end())
            places[node->second] = {{l, j}};
        }
  }


  std::vector<BristleLines::LineNode>
  BristleLines::own_nodes(const Streamlines  &streamlines,
                          const State        &state,
                          const ContactState &zone) const
  {
    // the areas of the lumped mortar matrix
    std::vector<double> areas(mesh.nodes.size());
    for (const Cell &cell : mesh.wall_elements())
      for (const unsigned int n : cell.nodes)
        if (zone.active[n])
          areas[n] += cell.geometry.weight / 4;

    std::vector<LineNode> result;
    for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
      {
        // the clearance of the node before the first one in contact tells where
        // on the segment contact begins
        const Node &node    = mesh.nodes[n];
        const auto &stencil = streamlines.at(n);
        const auto  touches = [&](const unsigned int node) {
          return zone.active[node] ||
                 (step && step->contacts[number].active[node]);
        };
        bool is_near = touches(n);
        if (node.locally_owned && stencil)
          for (const unsigned int neighbor : stencil->neighbors)
            is_near = is_near || touches(neighbor);
        if (!mesh.grid.closed || !is_near ||
            (!node.locally_owned && areas[n] == 0))
          continue;
        LineNode at;
        at.number   = node.number;
        at.line     = node.grid_index[0];
        at.place    = node.grid_index[1];
        at.touches  = zone.active[n];
        at.pressure = zone.pressure(n);
        at.x        = mesh.deformed_position(state.displacement, node, face);
        at.area     = areas[n];
        at.owned    = node.locally_owned;
        if (step)
          at.past = at_start(n);
        if (at.owned)
          for (unsigned int i = 0; i < 3; ++i)
            for (unsigned int part = 0; part < node.n_parts(); ++part)
              {
                const Tensor<1, 3> direction =
                  Node::sign_of_part(face * mesh.n_layers(), part) *
                  node.surface.frame[i];
                const auto dof = node.dof(i, part);
                // by free unknowns, since couplings are added to the tangent
                // without constraints
                if (!mesh.constraints.is_constrained(dof))
                  {
                    at.dofs.push_back(dof);
                    at.per_dof.push_back(direction);
                  }
                else
                  for (const auto &entry :
                       *mesh.constraints.get_constraint_entries(dof))
                    {
                      at.dofs.push_back(entry.first);
                      at.per_dof.push_back(entry.second * direction);
                    }
              }
        result.push_back(at);
      }
    return result;
  }


  BristleLaw::Past
  BristleLines::at_start(const unsigned int n) const
  {
    const PlacedBody *before = step->loads.body(number);
    Assert(before, ExcInternalError());
    const ContactState &zone = step->contacts[number];
    BristleLaw::Past    past;
    past.x = mesh.deformed_position(step->displacement, mesh.nodes[n], face);
    past.clearance = before->body.evaluate(past.x).clearance;
    past.shift     = body->body.present(before->body.at_rest(past.x)) - past.x;
    if (zone.active[n])
      for (unsigned int i = 0; i < 2; ++i)
        past.deflection[i] =
          -zone.multipliers[n][1 + i] / law->tangential_stiffness();
    return past;
  }


  void
  BristleLines::append_lines(const std::map<unsigned int, LineNode> &by_place,
                             const Rolling                          &rolling)
  {
    const std::vector<double> &grid_lines = mesh.grid.lines[1];
    const unsigned int         n          = mesh.grid.n_nodes(1);
    // particles move against the coordinate if the wheel rolls forward
    const bool backward = rolling.angular_velocity < 0;
    const auto after    = [&](const unsigned int place) {
      return (place + (backward ? 1 : n - 1)) % n;
    };
    const auto before = [&](const unsigned int place) {
      return (place + (backward ? n - 1 : 1)) % n;
    };
    const auto follow = [&](unsigned int place) {
      Line line;
      for (unsigned int k = 0; k < n; ++k, place = after(place))
        {
          const auto found = by_place.find(place);
          if (found == by_place.end())
            break;
          // the angle of a station is that of the segment to the node before it
          const unsigned int lower = (backward ? before(place) : place);
          line.stations.push_back(
            BristleLaw::station(body->body,
                                found->second.x,
                                found->second.touches,
                                grid_lines[lower + 1] - grid_lines[lower]));
          line.stations.back().pressure = found->second.pressure;
          line.nodes.push_back(found->second);
        }
      if (step)
        {
          std::vector<BristleLaw::Past> past;
          for (const LineNode &node : line.nodes)
            past.push_back(node.past);
          line.bristles = law->deflections_in_time(
            line.stations, past, step->duration, rolling);
        }
      else
        line.bristles = law->deflections(line.stations, rolling);
      lines.push_back(std::move(line));
    };

    bool any = false;
    // a line begins where the node before is not near the footprint
    for (const auto &node : by_place)
      if (by_place.count(before(node.first)) == 0)
        {
          follow(node.first);
          any = true;
        }
    // all of the line touches, or nearly so
    if (!any && !by_place.empty())
      {
        unsigned int start = by_place.begin()->first;
        for (const auto &node : by_place)
          if (!node.second.touches)
            start = node.first;
        follow(start);
      }
  }


  const BristleLaw::Bristle *
  BristleLines::at(const unsigned int node) const
  {
    if (!exist() || !places[node])
      return nullptr;
    const Line &line = lines[places[node]->first];
    return line.nodes[places[node]->second].touches
             ? &line.bristles[places[node]->second]
             : nullptr;
  }


  void
  BristleLines::set_multipliers(ContactState &zone) const
  {
    for (unsigned int n = 0; n < places.size(); ++n)
      if (const BristleLaw::Bristle *bristle = at(n))
        {
          zone.statuses[n] =
            (bristle->slips() ? ContactStatus::slip : ContactStatus::stick);
          for (unsigned int i = 0; i < 2; ++i)
            zone.multipliers[n][1 + i] =
              -law->tangential_stiffness() * bristle->deflection[i];
        }
  }


  Tensor<1, 3>
  BristleLines::slip_velocity(const unsigned int node) const
  {
    Tensor<1, 3> result;
    if (const BristleLaw::Bristle *bristle = at(node))
      for (unsigned int i = 0; i < 2; ++i)
        result +=
          bristle->slip_velocity[i] *
          lines[places[node]->first].stations[places[node]->second].tangents[i];
    return result;
  }


  template <typename Function>
  void
  BristleLines::for_own_bristles(const Function &function) const
  {
    for (unsigned int n = 0; n < places.size(); ++n)
      if (places[n] && mesh.nodes[n].locally_owned)
        function(n, lines[places[n]->first], places[n]->second);
  }


  Tensor<1, 3>
  BristleLines::force(const Line &line, const unsigned int j) const
  {
    Tensor<1, 3> force;
    if (line.nodes[j].touches)
      for (unsigned int c = 0; c < 2; ++c)
        force -=
          line.nodes[j].area * law->tangential_stiffness() *
          (line.bristles[j].deflection[c] + line.bristles[j].extrapolation[c]) *
          line.stations[j].tangents[c];
    return force;
  }


  Tensor<2, 3>
  BristleLines::force_derivative(const Line        &line,
                                 const unsigned int j,
                                 const unsigned int i) const
  {
    const BristleLaw::Bristle &bristle = line.bristles[j];
    Tensor<2, 3>               derivative;
    if (!line.nodes[j].touches || i < bristle.first)
      return derivative;
    const BristleLaw::Station &station = line.stations[j];
    for (unsigned int c = 0; c < 2; ++c)
      {
        const Tensor<1, 3> &t = station.tangents[c];
        derivative +=
          outer_product(t, bristle.per_position[i - bristle.first][c]);
        // the tangents turn with the normal
        if (i == j)
          derivative += bristle.deflection[c] * station.tangent_gradients[c];
      }
    return -line.nodes[j].area * law->tangential_stiffness() * derivative;
  }


  Tensor<1, 3>
  BristleLines::force_rate(const Line        &line,
                           const unsigned int j,
                           const LoadRates   &rates) const
  {
    Tensor<1, 3> rate;
    if (!line.nodes[j].touches)
      return rate;
    // a travel of the body is equivalent to the opposite motion of all nodes,
    // in time on a drum but for the first one that touches
    const Tensor<1, 3> motion = rates.travel * body->body.direction();
    if (rates.travel != 0)
      for (unsigned int i = line.bristles[j].first; i <= j; ++i)
        rate += force_derivative(line, j, i) * motion;
    // of the mean in a step
    const double part = (step && step->angular_velocity_is_given ? 0.5 : 1);
    for (unsigned int c = 0; c < 2; ++c)
      rate -= line.nodes[j].area * law->tangential_stiffness() * part *
              rates.angular_velocity *
              line.bristles[j].per_angular_velocity[c] *
              line.stations[j].tangents[c];
    return rate;
  }


  BristleLines::Powers
  BristleLines::powers(const double angular_velocity) const
  {
    std::vector<double> sums(2);
    for_own_bristles(
      [&](const unsigned int, const Line &line, const unsigned int j) {
        if (!line.nodes[j].touches)
          return;
        const BristleLaw::Bristle &bristle = line.bristles[j];
        const double               stiffness =
          line.nodes[j].area * law->tangential_stiffness();
        // with the mean of the segment, its work is all stored or lost
        Tensor<1, 2> mean = bristle.deflection;
        if (j > 0)
          mean = (mean + line.bristles[j - 1].deflection) / 2;
        sums[0] += stiffness * (mean * bristle.slip_velocity);
        if (j + 1 == line.nodes.size() || !line.nodes[j + 1].touches)
          sums[1] += stiffness / 2 * bristle.deflection.norm_square() *
                     std::abs(angular_velocity) / line.stations[j].angle;
      });
    Utilities::MPI::sum(sums, mesh.communicator, sums);
    return {sums[0], sums[1]};
  }


  void
  BristleLines::add_to_nodes(const unsigned int  n,
                             const Tensor<1, 3> &force,
                             LA::Vector         &nodal_forces) const
  {
    const Node &node = mesh.nodes[n];
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int part = 0; part < node.n_parts(); ++part)
        nodal_forces(node.dof(i, part)) +=
          Node::sign_of_part(face * mesh.n_layers(), part) *
          (node.surface.frame[i] * force);
  }


  void
  BristleLines::add_forces(LA::Vector &nodal_forces) const
  {
    for_own_bristles(
      [&](const unsigned int n, const Line &line, const unsigned int j) {
        add_to_nodes(n, force(line, j), nodal_forces);
      });
  }


  void
  BristleLines::add_couplings(std::vector<ForceTerm::Coupling> &couplings) const
  {
    for_own_bristles(
      [&](const unsigned int, const Line &line, const unsigned int j) {
        const LineNode &node = line.nodes[j];
        // also with nodes that do not touch now: the next ones that will
        for (unsigned int i = 0; i <= j; ++i)
          {
            const LineNode     &other = line.nodes[i];
            ForceTerm::Coupling coupling;
            coupling.nodes   = {node.number, other.number};
            coupling.rows    = node.dofs;
            coupling.columns = other.dofs;
            couplings.push_back(coupling);
            if (!node.touches || i < line.bristles[j].first)
              continue;
            couplings.back().stiffness.reinit(node.dofs.size(),
                                              other.dofs.size());
            // stiffnesses are minus the derivatives of forces
            const Tensor<2, 3> derivative = force_derivative(line, j, i);
            for (unsigned int a = 0; a < node.dofs.size(); ++a)
              for (unsigned int b = 0; b < other.dofs.size(); ++b)
                couplings.back().stiffness(a, b) =
                  -(node.per_dof[a] * (derivative * other.per_dof[b]));
          }
      });
  }


  void
  BristleLines::add_load_derivative(const LoadRates &rates,
                                    LA::Vector      &nodal_forces) const
  {
    for_own_bristles(
      [&](const unsigned int n, const Line &line, const unsigned int j) {
        add_to_nodes(n, force_rate(line, j, rates), nodal_forces);
      });
  }


  double
  BristleLines::add_work(
    const std::function<Tensor<1, 3>(const Tensor<1, 3> &)> &motion,
    const std::function<Tensor<1, 3>(const Tensor<1, 3> &)>
                                 &transposed_derivative,
    const std::vector<LoadRates> &rates,
    LA::Vector                   &gradient,
    std::vector<double>          &per_load) const
  {
    double work = 0;
    for_own_bristles(
      [&](const unsigned int n, const Line &line, const unsigned int j) {
        const LineNode &node = line.nodes[j];
        if (!node.touches)
          return;
        const Tensor<1, 3> moved = motion(
          halfway ? (Tensor<1, 3>(node.x) + Tensor<1, 3>(node.past.x)) / 2
                  : Tensor<1, 3>(node.x));
        work += moved * force(line, j);
        if (transposed_derivative)
          add_to_nodes(n,
                       (halfway ? 0.5 : 1.) *
                         transposed_derivative(force(line, j)),
                       gradient);
        // a bristle depends on all nodes that its particle has passed in
        // contact, also of other ranks
        for (unsigned int i = line.bristles[j].first; i <= j; ++i)
          {
            const Tensor<1, 3> per_position =
              moved * force_derivative(line, j, i);
            const LineNode &other = line.nodes[i];
            for (unsigned int b = 0; b < other.dofs.size(); ++b)
              gradient(other.dofs[b]) += other.per_dof[b] * per_position;
          }
        for (unsigned int r = 0; r < rates.size(); ++r)
          per_load[r] += moved * force_rate(line, j, rates[r]);
      });
    return work;
  }
} // namespace Biface
