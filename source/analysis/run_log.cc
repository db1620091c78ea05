// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cerrno>
#include <cstring>

#include <biface/analysis/run_log.h>

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
    opened = true;
    errno  = 0;
    // what was printed before the directory existed comes first
    file.open(file_name, append ? std::ios::app : std::ios::trunc);
    if (file)
      file << waiting;
    else
      out << "The log '" << file_name << "' cannot be written ("
          << (errno != 0 ? std::strerror(errno) : "unknown reason")
          << "); the run continues without it." << std::endl;
    std::string().swap(waiting);
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
    else if (is_first_rank && !opened)
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
} // namespace Biface
