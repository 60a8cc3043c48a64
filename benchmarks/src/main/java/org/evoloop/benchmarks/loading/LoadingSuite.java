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

/** Reading and compiling models, in a new process and in a warm one. */
public final class LoadingSuite implements Suite {
    /**
     * Allocates all memory before the first measurement: on a virtual machine that takes longer than everything else,
     * and varies between runs. The garbage collector is the one that {@code ./evoloop} uses; the compiler is C2 for
     * both.
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
        // Alternating, so that other load on the machine affects all of them.
        for (int time = 0; time < times; time++) {
            domSeconds = Math.min(domSeconds, dom.cpuSeconds());
            readSeconds = Math.min(readSeconds, read.cpuSeconds());
            emptySeconds = Math.min(emptySeconds, nothing.cpuSeconds());
        }
        Figures warm = Fork.of(LargePair.class, WARM_HEAP, quick ? "5" : "15").figures();
        Figures text = Fork.of(ReadText.class, WARM_HEAP, quick ? "20" : "100").figures();
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
                LargePair.row(warm),
                ReadText.row(text));
    }
}
