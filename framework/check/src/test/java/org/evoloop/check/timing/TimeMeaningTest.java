package org.evoloop.check.timing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.check.Lamp.lamp;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import org.evoloop.check.CheckInput;
import org.evoloop.check.TimedEvent;
import org.evoloop.check.properties.PropertyFile;
import org.evoloop.check.temporal.Formula;
import org.evoloop.check.temporal.Moment;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Sentry;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What is found while a converter runs, compared with the language's meaning, evaluated over the whole past. */
class TimeMeaningTest {
    private static final int TRACES = 3_000;
    private static final long SECOND = 1_000_000_000;
    private static final ModelPair LAMP = new ModelPair(
            lamp("original").build(),
            lamp("new")
                    .transition("On", "dim", "Dim")
                    .transition("Dim", "press", "On")
                    .build());
    private static final List<String> FORMULAS = List.of(
            "Off", "On", "Dim", "device Off", "device On", "event press", "event dim", "Off or Dim", "not On", "true");

    /** What was seen at a time: whether the subject held, and the other. */
    private record Seen(long at, boolean subject, boolean other) {}

    /** The meaning of each form, over all that was seen. */
    private record Meaning(List<Seen> seen, long end) {
        long at(int moment) {
            return seen.get(moment).at();
        }

        boolean begins(int moment) {
            return seen.get(moment).subject()
                    && (moment == 0 || !seen.get(moment - 1).subject());
        }

        int[] beginnings() {
            return IntStream.range(0, seen.size()).filter(this::begins).toArray();
        }

        /** The time of each violation. */
        List<Long> violations(TimeForm form) {
            LongStream found;
            if (form instanceof TimeForm.Response response) {
                found = LongStream.concat(tooSoon(response.span()), tooLate(response.span()));
            } else if (form instanceof TimeForm.Stay stay) {
                found = stays(stay.span());
            } else if (form instanceof TimeForm.Before before) {
                found = IntStream.of(beginnings())
                        .filter(begun -> lasted(begun) < before.minNanos())
                        .mapToLong(this::at);
            } else {
                TimeForm.Count count = (TimeForm.Count) form;
                found = IntStream.of(beginnings())
                        .filter(begun -> IntStream.of(beginnings())
                                        .filter(other -> other <= begun && at(begun) - at(other) <= count.windowNanos())
                                        .count()
                                > count.most())
                        .mapToLong(this::at);
            }
            return found.filter(time -> time <= end).sorted().boxed().toList();
        }

        /** Where the other holds for the first time after {@code begun}; the size if it does not. */
        private int answer(int begun) {
            return IntStream.range(begun, seen.size())
                    .filter(moment -> seen.get(moment).other())
                    .findFirst()
                    .orElse(seen.size());
        }

        /** One moment that is too soon for several is one violation. */
        private LongStream tooSoon(Span span) {
            return IntStream.of(beginnings())
                    .filter(begun -> answer(begun) < seen.size() && at(answer(begun)) - at(begun) < span.minNanos())
                    .map(this::answer)
                    .distinct()
                    .mapToLong(this::at);
        }

        /** What began several times at the same time is late once. */
        private LongStream tooLate(Span span) {
            return IntStream.of(beginnings())
                    .filter(begun -> answer(begun) == seen.size() || at(answer(begun)) - at(begun) > span.maxNanos())
                    .mapToLong(begun -> at(begun) + span.maxNanos() + 1)
                    .distinct();
        }

        private LongStream stays(Span span) {
            return IntStream.of(beginnings()).mapToLong(begun -> {
                int over = IntStream.range(begun, seen.size())
                        .filter(moment -> !seen.get(moment).subject())
                        .findFirst()
                        .orElse(seen.size());
                boolean ends = over < seen.size();
                if (ends && at(over) - at(begun) < span.minNanos()) {
                    return at(over);
                }
                boolean late = span.maxNanos() != Span.FOR_EVER && (!ends || at(over) - at(begun) > span.maxNanos());
                return late ? at(begun) + span.maxNanos() + 1 : Long.MAX_VALUE;
            });
        }

        /** How long the other has held when the subject begins, at least until this very time; -1 if it has not. */
        private long lasted(int begun) {
            int last = begun - 1;
            while (last >= 0 && !seen.get(last).other()) {
                last--;
            }
            if (last < 0 || (last < begun - 1 && at(last + 1) != at(begun))) {
                return -1;
            }
            int first = last;
            while (first > 0 && seen.get(first - 1).other()) {
                first--;
            }
            return at(begun) - at(first);
        }
    }

    private static String property(Random random) {
        String subject = pick(FORMULAS, random);
        String other = pick(FORMULAS, random);
        int least = random.nextInt(4);
        int most = least + random.nextInt(5);
        return switch (random.nextInt(6)) {
            case 0 -> "after " + subject + ", " + other + " within " + most + " s";
            case 1 -> "after " + subject + ", " + other + " within " + least + " s .. " + most + " s";
            case 2 -> pick(FORMULAS.subList(0, 5), random) + " never longer than " + (most + 1) + " s";
            case 3 -> pick(FORMULAS.subList(0, 5), random) + " never shorter than " + (most + 1) + " s";
            case 4 -> subject + " only after " + most + " s of " + pick(FORMULAS.subList(0, 5), random);
            default -> subject + " at most " + (1 + random.nextInt(3)) + " times in " + most + " s";
        };
    }

    private static <T> T pick(List<T> of, Random random) {
        return of.get(random.nextInt(of.size()));
    }

    /** A watch beside the list of all that it has seen and the times at which it has reported a violation. */
    private static final class Run {
        private final TimeForm form;
        private final TimeWatch watch;
        private final List<Seen> seen = new ArrayList<>();
        private final List<Long> reported = new ArrayList<>();
        private Configuration at = LAMP.initial();

        Run(String line) {
            TimeRules rules = PropertyFile.parse("lamp.txt", line, LAMP).time();
            form = rules.properties().get(0).form();
            watch = new TimeWatch(rules, LAMP, at, 0);
            see(0, null);
            poll(0);
        }

        private void see(long now, Event event) {
            Moment moment = new Moment(at, event);
            seen.add(new Seen(now, holds(form.subject(), moment), holds(form.other(), moment)));
        }

        private static boolean holds(Formula formula, Moment moment) {
            return formula.isSeenIn(moment, LAMP);
        }

        private void poll(long now) {
            while (watch.poll() != null) {
                reported.add(now);
            }
        }

        void passes(long until) {
            for (long due = watch.dueNanos(); due <= until; due = watch.dueNanos()) {
                watch.passed(due);
                poll(due);
            }
        }

        void happens(Random random, long now) {
            if (random.nextBoolean()) {
                Event event = new Event(random.nextBoolean() ? "press" : "dim");
                watch.comes(event, at, now);
                see(now, event);
            } else {
                at = new Configuration(
                        new State(random.nextBoolean() ? "Off" : "On"),
                        new State(pick(List.of("Off", "On", "Dim"), random)));
                watch.moved(at, now);
            }
            see(now, null);
            poll(now);
        }
    }

    @Test
    void whatIsReportedIsWhatTheLanguageMeans() {
        TreeMap<String, Integer> kinds = new TreeMap<>();
        for (long seed = 1; seed <= TRACES; seed++) {
            Random random = new Random(seed);
            String line = property(random);
            Run run = new Run(line);
            long now = 0;
            for (int step = random.nextInt(30); step >= 0; step--) {
                now += random.nextInt(3) * SECOND;
                run.passes(now);
                run.happens(random, now);
            }
            now += 10 * SECOND;
            run.passes(now);
            List<Long> meant = new Meaning(run.seen, now).violations(run.form);
            assertThat(run.reported).as("seed %d: %s, %s", seed, line, run.seen).isEqualTo(meant);
            String often = meant.isEmpty() ? "never" : meant.size() == 1 ? "once" : "often";
            kinds.merge(run.form.getClass().getSimpleName() + " " + often, 1, Integer::sum);
            if (meant.contains(0L)) {
                kinds.merge("at the start", 1, Integer::sum);
            }
        }
        assertThat(kinds).containsKey("at the start").hasSize(13);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            Off only after 2 s of On                 | true
            device Off only after 1 s of On          | true
            after Off, device Off within 1 s .. 2 s  | true
            On only after 1 s of Off                 | false
            after On, true within 1 s .. 2 s         | false
            Off never shorter than 1 s               | false
            """)
    void aViolationAtTheStartIsToldAsTheCheckTellsIt(String line, boolean isAtStart) {
        TimeRules rules =
                PropertyFile.parse("lamp.txt", "queue 0\n" + line, LAMP).time();
        TimeWatch watch = new TimeWatch(rules, LAMP, LAMP.initial(), 5);
        assertThat(watch.dueNanos() == 5).isEqualTo(isAtStart);
        assertThat(watch.poll() != null).isEqualTo(isAtStart);
        assertThat(watch.poll()).isNull();

        Stream<List<String>> counterexamples =
                TimeCheck.run(CheckInput.of(LAMP).withFunctions(Set.of()), rules, "lamp.txt").findings().stream()
                        .map(finding ->
                                finding.timed().stream().map(TimedEvent::what).toList());
        assertThat(counterexamples.anyMatch(way -> way.size() == 2 && way.get(0).equals("start")))
                .isEqualTo(isAtStart);
    }

    @Test
    void whereItGoesOnNothingIsViolatedYet() {
        TimeRules rules =
                PropertyFile.parse("lamp.txt", "Dim only after 2 s of On", LAMP).time();
        Configuration dim = new Configuration(new State("On"), new State("Dim"));
        TimeWatch watch = new TimeWatch(rules, LAMP, dim, 0);
        assertThat(watch.dueNanos()).isEqualTo(Sentry.NEVER);
        assertThat(watch.poll()).isNull();
    }

    @Test
    void eachIsToldIfTheTimeIsLookedAtLate() {
        TimeRules rules = PropertyFile.parse("lamp.txt", "after event dim, On within 3 s", LAMP)
                .time();
        TimeWatch watch = new TimeWatch(rules, LAMP, LAMP.initial(), 0);
        for (int second = 0; second < 3; second++) {
            watch.comes(new Event("dim"), LAMP.initial(), second * SECOND);
        }
        watch.passed(5 * SECOND);
        assertThat(Stream.generate(watch::poll).takeWhile(each -> each != null)).hasSize(2);
        watch.passed(6 * SECOND);
        assertThat(watch.poll()).isNotNull();
        assertThat(watch.dueNanos()).isEqualTo(Sentry.NEVER);
    }
}
