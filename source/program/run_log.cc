// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <biface/program/run_log.h>

namespace Biface
{
  RunLog::RunLog(std::ostream &screen,
                 const bool    quiet,
                 const bool    is_first_rank)
    : screen(screen)
    , on_screen(is_first_rank && !quiet)
    , is_first_rank(is_first_rank)
    , out(this)
  {}


  void
  RunLog::open(const std::string &file_name, const bool append)
  {
    if (!is_first_rank)
      return;
    file.open(file_name, append ? std::ios::app : std::ios::trunc);
    file << waiting;
    waiting.clear();
  }


  void
  RunLog::note(const std::string &text)
  {
    if (file.is_open())
      file << text << std::flush;
  }


  RunLog::int_type
  RunLog::overflow(const int_type c)
  {
    if (traits_type::eq_int_type(c, traits_type::eof()))
      return traits_type::not_eof(c);
    const char letter = traits_type::to_char_type(c);
    xsputn(&letter, 1);
    return c;
  }


  std::streamsize
  RunLog::xsputn(const char *text, const std::streamsize n)
  {
    if (on_screen)
      screen.write(text, n);
    // a log that cannot be written does not end a run
    if (file.is_open())
      file.write(text, n);
    else if (is_first_rank)
      waiting.append(text, n);
    return n;
  }


  int
  RunLog::sync()
  {
    if (on_screen)
      screen.flush();
    if (file.is_open())
      file.flush();
    return 0;
  }


  StepCounter::StepCounter(const std::vector<Stage> &stages,
                           const Progress           &progress)
    : stages(stages), at_begin(done(progress))
  {
    for (const Stage &stage : stages)
      {
        planned += stage.n_steps;
        if (!make_control(stage)->has_equal_steps())
          predictable = false;
      }
  }


  double
  StepCounter::done(const Progress &progress) const
  {
    double sum = 0;
    for (unsigned int i = 0; i < progress.stage; ++i)
      sum += stages[i].n_steps;
    const Stage &stage = stages[progress.stage];
    if (progress.stage_begun)
      sum += stage.n_steps * progress.control.done;
    return sum;
  }


  std::string
  StepCounter::line(const StepReport &report, const Progress &progress) const
  {
    const double now     = done(progress);
    const double seconds = timer.wall_time();

    std::string text = "  step " + std::to_string(report.step);
    if (predictable)
      text += " of " + std::to_string(report.step +
                                      static_cast<unsigned int>(std::lround(
                                        std::max(0., planned - now))));
    char part[256];
    std::snprintf(
      part,
      sizeof(part),
      ": approach %.6g, force %.6g, contact %u nodes, area %.6g, "
      "greatest pressure %.4g, %u iterations, %.2f s; %.3g s so far",
      report.approach,
      report.contact.force,
      report.contact.n_nodes,
      report.contact.area,
      report.contact.max_pressure,
      report.iterations,
      report.seconds,
      seconds);
    text += part;
    if (const unsigned int n = report.n_negative_pivots.value_or(0); n > 0)
      text += ", " + std::to_string(n) +
              (n == 1 ? " negative pivot" : " negative pivots");
    if (predictable && now > at_begin && planned > now)
      {
        std::snprintf(part,
                      sizeof(part),
                      ", about %.2g s to go",
                      seconds * (planned - now) / (now - at_begin));
        text += part;
      }
    return text;
  }
} // namespace Biface
