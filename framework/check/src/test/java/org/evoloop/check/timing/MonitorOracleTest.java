package org.evoloop.check.timing;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.evoloop.check.temporal.Formula;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfEnvironmentVariable;
import org.junit.jupiter.api.io.TempDir;

/** The monitors find what reelay and RTAMT find in the same traces: ./evoloop test --oracles. */
@Tag("slow")
@EnabledIfEnvironmentVariable(named = "EVOLOOP_ORACLES", matches = ".+")
class MonitorOracleTest {
    private static final int TRACES = 10_000;
    private static final Formula ANY = new Formula.Constant(true);

    @TempDir
    private Path directory;

    /** @param codes one character per tick: bit 0 is the subject, bit 1 the other */
    private record Trace(String form, int length, String codes) {
        static Trace of(Random random) {
            List<String> forms = List.of("response", "longest", "shortest", "before", "count");
            String form = forms.get(random.nextInt(forms.size()));
            StringBuilder codes = new StringBuilder();
            int code = random.nextInt(4);
            for (int tick = random.nextInt(40); tick >= 0; tick--) {
                code = random.nextInt(3) == 0 ? random.nextInt(4) : code;
                codes.append(code);
            }
            return new Trace(form, (form.equals("shortest") ? 2 : 1) + random.nextInt(6), codes.toString());
        }

        TimeForm timeForm() {
            return switch (form) {
                case "response" -> new TimeForm.Response(ANY, ANY, new Span(0, length));
                case "longest" -> new TimeForm.Stay(ANY, new Span(0, length));
                case "shortest" -> new TimeForm.Stay(ANY, new Span(length, Span.FOR_EVER));
                case "before" -> new TimeForm.Before(ANY, ANY, length);
                default -> new TimeForm.Count(ANY, 1, length);
            };
        }

        /**
         * The tick of the first violation; -1 if there is none. A violation shown by time alone belongs to the tick
         * before.
         */
        int firstViolation() {
            TimeMonitor monitor = TimeMonitor.of(timeForm(), 1);
            for (int tick = 0; tick < codes.length(); tick++) {
                if (monitor.lapsed(tick)) {
                    return tick - 1;
                }
                int code = codes.charAt(tick) - '0';
                if (monitor.sees(tick, (code & 1) != 0, (code & 2) != 0)) {
                    return tick;
                }
            }
            return monitor.lapsed(codes.length()) ? codes.length() - 1 : -1;
        }
    }

    @Test
    void twoMonitorsByOthersSayTheSame() throws IOException, InterruptedException {
        long seed = Optional.ofNullable(System.getenv("EVOLOOP_SEED"))
                .map(Long::parseLong)
                .orElseGet(() -> new Random().nextLong());
        Random random = new Random(seed);
        List<String> traces = new ArrayList<>();
        List<String> ours = new ArrayList<>();
        for (int number = 0; number < TRACES; number++) {
            Trace trace = Trace.of(random);
            traces.add(trace.form() + " " + trace.length() + " " + trace.codes());
            ours.add(trace.firstViolation() + " " + trace.firstViolation());
        }
        assertThat(ours).contains("-1 -1").anyMatch(each -> !each.startsWith("-1"));
        List<String> theirs = judge(traces);
        assertThat(theirs).hasSameSizeAs(ours);
        for (int number = 0; number < TRACES; number++) {
            assertThat(theirs.get(number))
                    .as("seed %d: %s", seed, traces.get(number))
                    .isEqualTo(ours.get(number));
        }
    }

    private List<String> judge(List<String> traces) throws IOException, InterruptedException {
        Path asked = Files.write(directory.resolve("traces"), traces);
        Path answers = directory.resolve("answers");
        Path root = Path.of(System.getProperty("evoloop.root"));
        Process judges = new ProcessBuilder(
                        System.getenv("EVOLOOP_ORACLES"),
                        root.resolve("framework/check/oracles/monitors.py").toString())
                .redirectInput(asked.toFile())
                .redirectOutput(answers.toFile())
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();
        assertThat(judges.waitFor()).isZero();
        return Files.readAllLines(answers);
    }
}
