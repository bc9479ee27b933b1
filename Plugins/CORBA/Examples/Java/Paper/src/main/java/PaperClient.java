// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause

import LMS3D.DataExchange;
import LMS3D.DataExchangeHelper;
import java.util.Properties;
import org.omg.CORBA.ORB;
import org.omg.CORBA.SystemException;

/**
 * Fetches a scan with the paper's interface and prints range (metres), alpha and beta (degrees) of
 * each beam, one beam per line. It is compiled from LMS3D.idl alone.
 */
public final class PaperClient {
  private PaperClient() {}

  public static void main(String[] arguments) {
    if (arguments.length != 1) {
      System.err.println("Usage: java -jar paper-client.jar IOR-OR-CORBALOC");
      System.exit(2);
    }
    try {
      ORB orb = makeORB();
      DataExchange scanner = DataExchangeHelper.narrow(orb.string_to_object(arguments[0]));
      print(scanner.fetch());
      orb.destroy();
    } catch (SystemException problem) {
      System.err.println("paper-client: " + problem);
      System.exit(1);
    }
  }

  private static ORB makeORB() {
    Properties properties = new Properties();
    properties.put("org.omg.CORBA.ORBClass", "org.jacorb.orb.ORB");
    properties.put("org.omg.CORBA.ORBSingletonClass", "org.jacorb.orb.ORBSingleton");
    // Milliseconds; longer than the server's longest wait, so only a server that hangs exceeds it.
    properties.put("jacorb.connection.client.pending_reply_timeout", "15000");
    return ORB.init((String[]) null, properties);
  }

  private static void print(float[] triples) {
    StringBuilder text = new StringBuilder();
    for (int i = 0; i < triples.length; i += 3) {
      text.append(triples[i]).append('\t').append(triples[i + 1]).append('\t');
      text.append(triples[i + 2]).append('\n');
    }
    System.out.print(text);
  }
}
