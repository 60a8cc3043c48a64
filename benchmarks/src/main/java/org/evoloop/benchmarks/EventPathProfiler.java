package org.evoloop.benchmarks;

import java.util.List;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.infra.BenchmarkParams;
import org.openjdk.jmh.infra.IterationParams;
import org.openjdk.jmh.profile.InternalProfiler;
import org.openjdk.jmh.results.IterationResult;
import org.openjdk.jmh.results.ResultRole;
import org.openjdk.jmh.results.SampleTimeResult;
import org.openjdk.jmh.util.SampleBuffer;

/** Adds what the {@link PathTimer} has measured to the results of an iteration. JMH makes it by its name. */
public final class EventPathProfiler implements InternalProfiler {
    static final String LABEL = "eventPath";

    @Override
    public String getDescription() {
        return "from getEvent's return to the call of the execute component";
    }

    @Override
    public void beforeIteration(BenchmarkParams benchmark, IterationParams iteration) {
        PathTimer.SHARED.clear();
    }

    @Override
    public List<SampleTimeResult> afterIteration(
            BenchmarkParams benchmark, IterationParams iteration, IterationResult result) {
        SampleBuffer samples = PathTimer.SHARED.samples();
        return samples.count() == 0
                ? List.of()
                : List.of(new SampleTimeResult(ResultRole.SECONDARY, LABEL, samples, TimeUnit.MICROSECONDS));
    }
}
