// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause

import LMS3D.Axis;
import LMS3D.InvalidArgument;
import LMS3D.LaserScanner;
import LMS3D.LaserScannerHelper;
import LMS3D.Pose;
import LMS3D.Scan;
import LMS3D.Vector3;
import java.util.Properties;
import org.omg.CORBA.ORB;
import org.omg.CORBA.SystemException;
import org.omg.CORBA.UserException;

/**
 * Moves the sensor, waits for a scan that was made wholly from there, and prints range (metres),
 * alpha and beta (degrees) of each beam, one beam per line.
 */
public final class ScannerClient {
  private static final int WAIT_MILLISECONDS = 10_000;

  private ScannerClient() {}

  public static void main(String[] arguments) {
    if (arguments.length != 4) {
      System.err.println("Usage: java -jar scanner-client.jar IOR-OR-CORBALOC X Y Z");
      System.exit(2);
    }
    try {
      ORB orb = makeORB();
      LaserScanner scanner = LaserScannerHelper.narrow(orb.string_to_object(arguments[0]));
      long generation = move(scanner, new Vector3(Double.parseDouble(arguments[1]),
          Double.parseDouble(arguments[2]), Double.parseDouble(arguments[3])));
      Scan scan = scanner.getScan();
      if (scan.header.generation != generation) {
        fail("another client has changed the settings meanwhile");
      }
      print(scan);
      orb.destroy();
    } catch (InvalidArgument problem) {
      fail("InvalidArgument: " + problem.reason);
    } catch (UserException | SystemException | NumberFormatException problem) {
      fail(problem.toString());
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

  /** Waits for the first scan from there, and returns the generation of its scans. */
  private static long move(LaserScanner scanner, Vector3 position) throws UserException {
    Pose pose = scanner.getPose();
    pose.position = position;
    long generation = scanner.setPose(pose);
    scanner.waitForScan(0, generation, WAIT_MILLISECONDS);
    return generation;
  }

  private static void print(Scan scan) {
    Axis alpha = scan.header.settings.alpha;
    Axis beta = scan.header.settings.beta;
    StringBuilder text = new StringBuilder();
    for (int beam = 0; beam < scan.beamRanges.length; ++beam) {
      text.append(scan.beamRanges[beam]).append('\t');
      text.append(getAngle(alpha, beam % alpha.count)).append('\t');
      text.append(getAngle(beta, beam / alpha.count)).append('\n');
    }
    System.out.print(text);
  }

  /** Returns an angle of an axis as LMS3DScanner.idl defines it. */
  private static double getAngle(Axis axis, int i) {
    boolean isCircle = Math.abs(axis.stop - axis.start - 360.0) <= 1e-6;
    int steps = Math.max(1, isCircle ? axis.count : axis.count - 1);
    return axis.start + (axis.stop - axis.start) * i / steps;
  }

  private static void fail(String problem) {
    System.err.println("scanner-client: " + problem);
    System.exit(1);
  }
}
