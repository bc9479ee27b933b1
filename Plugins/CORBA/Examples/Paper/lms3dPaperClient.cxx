// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
// lms3d-paper-client REFERENCE: fetches a scan with the paper's interface and prints its nearest
// return.
#include "LMS3D.hh"

#include <iostream>

namespace
{
void PrintNearest(const LMS3D::Data& triples)
{
  CORBA::ULong nearest = 0;
  CORBA::ULong returns = 0;
  for (CORBA::ULong i = 0; i < triples.length(); i += 3)
  {
    if (triples[i] > 0.0f)
    {
      nearest = returns == 0 || triples[i] < triples[nearest] ? i : nearest;
      ++returns;
    }
  }
  std::cout << triples.length() / 3 << " beams, " << returns << " returns\n";
  if (returns > 0)
  {
    std::cout << "nearest: r " << triples[nearest] << " m, alpha " << triples[nearest + 1]
              << ", beta " << triples[nearest + 2] << " degrees\n";
  }
}
} // namespace

int main(int argc, char* argv[])
{
  try
  {
    // Milliseconds. Without it the client would wait forever for a server that hangs.
    const char* options[][2] = { { "clientCallTimeOutPeriod", "20000" }, { nullptr, nullptr } };
    const CORBA::ORB_var orb = CORBA::ORB_init(argc, argv, "omniORB4", options);
    const CORBA::Object_var object = orb->string_to_object(argc > 1 ? argv[1] : "");
    const LMS3D::DataExchange_var scanner = LMS3D::DataExchange::_narrow(object);
    if (CORBA::is_nil(scanner))
    {
      std::cerr << "Usage: lms3d-paper-client CORBALOC-OR-IOR\n";
      return 2;
    }
    const LMS3D::Data_var triples = scanner->fetch();
    PrintNearest(triples);
    orb->destroy();
    if (!std::cout.flush())
    {
      std::cerr << "lms3d-paper-client: the standard output cannot be written\n";
      return 1;
    }
    return 0;
  }
  catch (const CORBA::Exception& problem)
  {
    std::cerr << "lms3d-paper-client: " << problem._name() << '\n';
    return 1;
  }
}
