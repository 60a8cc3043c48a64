package org.evoloop.benchmarks.report;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** The peak resident memory of a process so far, in MB. */
public final class ResidentMemory {
    private ResidentMemory() {}

    /** The peak of this process. */
    public static double ofThisProcess() throws IOException {
        return megabytes("self");
    }

    /** The peak of another process. */
    public static double of(long pid) throws IOException {
        return megabytes(Long.toString(pid));
    }

    private static double megabytes(String process) throws IOException {
        Path status = Path.of("/proc", process, "status");
        for (String line : Files.readAllLines(status)) {
            if (line.startsWith("VmHWM:")) {
                return Double.parseDouble(line.replaceAll("[^0-9]", "")) / 1024;
            }
        }
        throw new IOException(status + " has no VmHWM");
    }
}
