package org.evoloop.benchmarks.loading;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.evoloop.benchmarks.report.Figures;
import org.evoloop.benchmarks.report.Fork;
import org.evoloop.benchmarks.report.Row;
import org.evoloop.benchmarks.report.Suite;
import org.evoloop.xmi.ModelFiles;

/** Reading and compiling in a process that has just begun and in one that is warm. */
public final class LoadingSuite implements Suite {
    /**
     * All memory is handed out before the first time: on a virtual machine that takes longer than all the rest, and
     * differs from run to run. The collector is the one that {@code ./evoloop} chooses; the compiler is the last one,
     * for both.
     */
    private static final List<String> WARM_HEAP =
            List.of("-XX:+UseSerialGC", "-Xms1g", "-Xmx1g", "-XX:+AlwaysPreTouch");

    @Override
    public String name() {
        return "loading";
    }

    @Override
    public List<Row> measure(boolean quick) throws Exception {
        int times = quick ? 3 : 10;
        String file =
                ModelFiles.find("models/cleaning-robot.xml", LoadingSuite.class).toString();
        Fork read = Fork.of(ReadPair.class, Fork.SHIPPED_OPTIONS, file);
        Fork dom = Fork.of(ParseDom.class, Fork.SHIPPED_OPTIONS, file);
        Fork nothing = Fork.java("-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1", "-version");
        double domSeconds = Double.POSITIVE_INFINITY;
        double readSeconds = Double.POSITIVE_INFINITY;
        double emptySeconds = Double.POSITIVE_INFINITY;
        // By turns, so that a busy moment of the machine hits all of them.
        for (int time = 0; time < times; time++) {
            domSeconds = Math.min(domSeconds, dom.cpuSeconds());
            readSeconds = Math.min(readSeconds, read.cpuSeconds());
            emptySeconds = Math.min(emptySeconds, nothing.cpuSeconds());
        }
        Figures warm = Fork.of(LargePair.class, WARM_HEAP, quick ? "5" : "15").figures();
        return List.of(
                new Row(
                        "read and compile " + Files.size(Path.of(file)) / 1000 + " kB, cold, processor time",
                        "s",
                        readSeconds,
                        Row.Goal.atMostTimes(3, "JDK DOM parse", domSeconds),
                        Map.of("empty JVM", emptySeconds)),
                new Row(
                        "the same, resident memory",
                        "MB",
                        read.figures().get("rss"),
                        Row.Goal.atMost(55),
                        Map.of("JDK DOM parse", dom.figures().get("rss"))),
                LargePair.row(warm));
    }
}
