package org.evoloop.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import org.evoloop.engine.Scene.Act;
import org.evoloop.evolution.OnFailure;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Gives the real core every interleaving of what can happen. What may happen how often is part of a test's name; within
 * that, stories are followed to their ends, or up to the given length. A violation is printed as a story.
 */
class ExplorationTest {
    private static final int TO_THE_END = Integer.MAX_VALUE;

    /** An adapter that keeps the order with a device that can report its state, and one without either. */
    private static Stream<Scene> bestAndWorst(Scene scene) {
        return Stream.of(scene, scene.mute().outOfOrder());
    }

    private static Stream<Scene> littleOfEach(Scene scene) {
        return Stream.of(
                        scene.with(3, Act.PRESS).with(2, Act.OWN),
                        scene.with(2, Act.PRESS, Act.GIVE_UP).with(1, Act.OWN),
                        scene.with(2, Act.PRESS, Act.OWN).with(1, Act.STOP),
                        scene.with(1, Act.PRESS, Act.OWN, Act.JUMP, Act.GIVE_UP),
                        scene.with(2, Act.PRESS, Act.RAISE).with(1, Act.OWN),
                        scene.sending().with(1, Act.PRESS, Act.ASK, Act.OWN, Act.CHANGE, Act.GIVE_UP),
                        scene.with(2, Act.PRESS, Act.FAIL).with(1, Act.OWN, Act.DISMISS),
                        scene.with(2, Act.PRESS, Act.END).with(1, Act.OWN),
                        scene.with(1, Act.PRESS, Act.RAISE, Act.STOP, Act.END))
                .flatMap(ExplorationTest::bestAndWorst);
    }

    static Stream<Scene> ofTheBulb() {
        return littleOfEach(Scene.bulb());
    }

    static Stream<Scene> ofTheRobot() {
        return littleOfEach(Scene.robot());
    }

    @ParameterizedTest
    @MethodSource("ofTheBulb")
    void allStoriesOfTheBulb(Scene scene) {
        explore(scene, TO_THE_END);
    }

    @ParameterizedTest
    @MethodSource("ofTheRobot")
    void storiesOfTheRobot(Scene scene) {
        explore(scene, 8);
    }

    @ParameterizedTest
    @MethodSource("ofTheRobot")
    @Tag("slow")
    void allStoriesOfTheRobot(Scene scene) {
        explore(scene, TO_THE_END);
    }

    static Stream<Scene> ofTheGrinder() {
        Scene scene = Scene.grinder();
        return Stream.of(
                        scene.with(4, Act.PRESS),
                        scene.with(3, Act.PRESS).with(1, Act.OWN, Act.STOP),
                        scene.sending().with(2, Act.PRESS).with(1, Act.RAISE, Act.ASK, Act.FAIL),
                        scene.with(2, Act.PRESS, Act.GIVE_UP).with(1, Act.OWN),
                        scene.with(2, Act.PRESS).with(1, Act.GIVE_UP, Act.DISMISS, Act.END))
                .flatMap(ExplorationTest::bestAndWorst);
    }

    @ParameterizedTest
    @MethodSource("ofTheGrinder")
    void allStoriesOfTheGrinder(Scene scene) {
        explore(scene, TO_THE_END);
    }

    static Stream<Scene> ofOtherQueues() {
        Scene none = Scene.grinder().withQueue(0);
        Scene three = Scene.grinder().withQueue(3);
        return Stream.of(
                        none.with(3, Act.PRESS).with(1, Act.OWN, Act.STOP),
                        none.with(2, Act.PRESS).with(1, Act.RAISE, Act.END),
                        three.with(5, Act.PRESS))
                .flatMap(ExplorationTest::bestAndWorst);
    }

    @ParameterizedTest
    @MethodSource("ofOtherQueues")
    void allStoriesWithMoreOrLessRoom(Scene scene) {
        explore(scene, TO_THE_END);
    }

    static Stream<Scene> ofTheLamp() {
        Scene scene = Scene.lamp();
        return Stream.of(
                        scene.with(3, Act.OWN).with(1, Act.PRESS),
                        scene.with(2, Act.PRESS).with(1, Act.OWN, Act.STOP, Act.FAIL),
                        scene.with(2, Act.OWN).with(1, Act.PRESS, Act.GIVE_UP),
                        scene.with(1, Act.PRESS, Act.JUMP, Act.GIVE_UP),
                        scene.sending().with(1, Act.PRESS, Act.OWN, Act.ASK),
                        scene.with(2, Act.OWN).with(1, Act.PRESS, Act.END),
                        scene.with(1, Act.PRESS, Act.RAISE, Act.STOP, Act.END),
                        scene.onFailure(OnFailure.GO_BACK).with(2, Act.OWN).with(1, Act.PRESS, Act.FAIL),
                        scene.onFailure(OnFailure.OTHER_WAY).with(2, Act.OWN).with(1, Act.PRESS, Act.FAIL),
                        scene.onFailure(OnFailure.OTHER_WAY).with(1, Act.PRESS, Act.OWN, Act.FAIL, Act.JUMP))
                .flatMap(ExplorationTest::bestAndWorst);
    }

    @ParameterizedTest
    @MethodSource("ofTheLamp")
    void allStoriesOfTheLamp(Scene scene) {
        explore(scene, TO_THE_END);
    }

    static Stream<Scene> moreOfTheLamp() {
        Scene scene = Scene.lamp();
        return Stream.of(
                        scene.with(3, Act.PRESS).with(2, Act.OWN),
                        scene.with(2, Act.PRESS, Act.OWN).with(1, Act.STOP),
                        scene.with(2, Act.PRESS, Act.OWN).with(1, Act.FAIL),
                        scene.onFailure(OnFailure.OTHER_WAY).with(2, Act.PRESS, Act.OWN, Act.FAIL),
                        scene.with(1, Act.PRESS, Act.OWN, Act.JUMP, Act.GIVE_UP))
                .flatMap(ExplorationTest::bestAndWorst);
    }

    @ParameterizedTest
    @MethodSource("moreOfTheLamp")
    @Tag("slow")
    void moreStoriesOfTheLamp(Scene scene) {
        explore(scene, TO_THE_END);
    }

    static Stream<Scene> ofPlansThatBreakOff() {
        return Stream.of(OnFailure.GO_BACK, OnFailure.OTHER_WAY)
                .flatMap(then -> Stream.of(Scene.robot(), Scene.bulb()).map(scene -> scene.onFailure(then)))
                .flatMap(scene -> Stream.of(
                        scene.with(2, Act.PRESS, Act.FAIL).with(1, Act.OWN),
                        scene.with(2, Act.PRESS).with(1, Act.FAIL, Act.STOP, Act.RAISE),
                        scene.with(1, Act.PRESS, Act.OWN, Act.GIVE_UP).with(2, Act.FAIL),
                        scene.with(1, Act.PRESS, Act.JUMP, Act.END).with(2, Act.FAIL)))
                .flatMap(ExplorationTest::bestAndWorst);
    }

    @ParameterizedTest
    @MethodSource("ofPlansThatBreakOff")
    void allStoriesOfPlansThatBreakOff(Scene scene) {
        explore(scene, TO_THE_END);
    }

    static Stream<Scene> ofLostReports() {
        return Stream.of(Scene.sliding(), Scene.slipping(), Scene.robot())
                .flatMap(scene -> Stream.of(
                        scene.with(3, Act.OWN).with(2, Act.LOSE),
                        scene.with(2, Act.OWN).with(1, Act.LOSE, Act.PRESS, Act.STOP),
                        scene.with(2, Act.OWN).with(1, Act.LOSE, Act.PRESS, Act.FAIL),
                        scene.with(2, Act.OWN).with(1, Act.LOSE, Act.PRESS, Act.GIVE_UP),
                        scene.with(2, Act.OWN).with(1, Act.LOSE, Act.PRESS, Act.END)))
                .flatMap(ExplorationTest::bestAndWorst);
    }

    @ParameterizedTest
    @MethodSource("ofLostReports")
    void allStoriesInWhichAReportIsLost(Scene scene) {
        explore(scene, TO_THE_END);
    }

    static Stream<Scene> ofOldPresses() {
        return Stream.of(Scene.bulb(), Scene.robot(), Scene.grinder())
                .map(scene -> scene.withPressAge(4))
                .flatMap(scene -> Stream.of(
                        scene.with(2, Act.PRESS).with(1, Act.OWN, Act.STOP),
                        scene.with(2, Act.PRESS).with(1, Act.OWN, Act.GIVE_UP),
                        scene.with(2, Act.PRESS, Act.END),
                        scene.onFailure(OnFailure.GO_BACK).with(2, Act.PRESS).with(1, Act.FAIL, Act.END)))
                .flatMap(ExplorationTest::bestAndWorst);
    }

    @ParameterizedTest
    @MethodSource("ofOldPresses")
    void allStoriesOfPressesThatBecomeTooOld(Scene scene) {
        explore(scene, TO_THE_END);
    }

    static Stream<Scene> evolving() {
        return Stream.of(Scene.dancingRobot(), Scene.busyRobot(), Scene.plainBulb())
                .flatMap(scene -> Stream.of(
                        scene.with(2, Act.EVOLVE, Act.PRESS).with(1, Act.OWN),
                        scene.with(2, Act.PRESS).with(1, Act.EVOLVE, Act.RAISE, Act.STOP),
                        scene.with(1, Act.EVOLVE, Act.PRESS, Act.OWN, Act.GIVE_UP),
                        scene.with(1, Act.EVOLVE, Act.PRESS, Act.OWN, Act.JUMP),
                        scene.with(2, Act.PRESS).with(1, Act.EVOLVE, Act.STOP, Act.END, Act.OWN),
                        scene.sending().with(1, Act.PRESS, Act.ASK, Act.EVOLVE, Act.FAIL, Act.END)))
                .flatMap(ExplorationTest::bestAndWorst);
    }

    @ParameterizedTest
    @MethodSource("evolving")
    void allStoriesInWhichOtherModelsTakeOver(Scene scene) {
        explore(scene, TO_THE_END);
    }

    static Stream<Scene> everything() {
        return Stream.of(Scene.bulb(), Scene.dancingRobot())
                .map(scene -> scene.with(2, Act.values()))
                .flatMap(ExplorationTest::bestAndWorst);
    }

    @ParameterizedTest
    @MethodSource("everything")
    void everythingTogether(Scene scene) {
        explore(scene, 5);
    }

    @ParameterizedTest
    @MethodSource("everything")
    @Tag("slow")
    void everythingTogetherDeeper(Scene scene) {
        explore(scene, 7);
    }

    static Stream<Scene> deeper() {
        return Stream.of(Scene.bulb(), Scene.robot())
                .flatMap(scene -> Stream.of(
                        scene.with(4, Act.PRESS).with(3, Act.OWN),
                        scene.with(2, Act.PRESS, Act.OWN, Act.GIVE_UP).with(1, Act.STOP),
                        scene.with(2, Act.PRESS, Act.OWN, Act.END).with(1, Act.GIVE_UP, Act.RAISE),
                        scene.with(2, Act.PRESS, Act.OWN, Act.GIVE_UP).with(1, Act.JUMP)))
                .flatMap(ExplorationTest::bestAndWorst);
    }

    @ParameterizedTest
    @MethodSource("deeper")
    @Tag("slow")
    void moreStoriesOfThePapersPairs(Scene scene) {
        explore(scene, 14);
    }

    static Stream<Scene> randomPairs() {
        return LongStream.concat(LongStream.rangeClosed(1, 5), LongStream.of(new Random().nextLong()))
                .mapToObj(RandomPair::scene)
                .map(scene -> scene.with(1, Act.PRESS, Act.OWN, Act.GIVE_UP, Act.RAISE, Act.STOP, Act.END))
                .flatMap(ExplorationTest::bestAndWorst);
    }

    @ParameterizedTest
    @MethodSource("randomPairs")
    void storiesOfRandomPairs(Scene scene) {
        explore(scene, 8);
    }

    @ParameterizedTest
    @MethodSource("randomPairs")
    @Tag("slow")
    void longerStoriesOfRandomPairs(Scene scene) {
        explore(scene, 12);
    }

    static Stream<Scene> needing() {
        Stream<Scene> drawn = Stream.of(DeviceStateScenes.door(), DeviceStateScenes.air())
                .flatMap(scene -> Stream.of(
                        scene.with(2, Act.PRESS, Act.OWN),
                        scene.with(2, Act.PRESS).with(1, Act.OWN, Act.STOP, Act.FAIL),
                        scene.with(2, Act.PRESS).with(1, Act.GIVE_UP, Act.JUMP),
                        scene.outOfOrder().with(2, Act.PRESS).with(1, Act.OWN, Act.JUMP),
                        scene.with(1, Act.PRESS, Act.END, Act.JUMP),
                        scene.with(2, Act.PRESS).with(1, Act.OWN, Act.END, Act.ASK)));
        Stream<Scene> random = LongStream.concat(LongStream.rangeClosed(1, 8), LongStream.of(new Random().nextLong()))
                .mapToObj(RandomPair::needing)
                .map(scene -> scene.with(1, Act.PRESS, Act.OWN, Act.GIVE_UP, Act.FAIL, Act.STOP, Act.END, Act.ASK));
        Stream<Scene> evolving = Stream.of(DeviceStateScenes.restingFan(), DeviceStateScenes.boostedFan())
                .map(scene -> scene.with(2, Act.PRESS, Act.EVOLVE).with(1, Act.FAIL, Act.GIVE_UP, Act.END));
        return Stream.of(drawn, random, evolving).flatMap(scenes -> scenes).flatMap(ExplorationTest::bestAndWorst);
    }

    @ParameterizedTest
    @MethodSource("needing")
    void storiesOfStatesThatNeedTheDevice(Scene scene) {
        explore(scene, 10);
    }

    @ParameterizedTest
    @MethodSource("needing")
    @Tag("slow")
    void longerStoriesOfStatesThatNeedTheDevice(Scene scene) {
        explore(scene, 13);
    }

    static Stream<Scene> ofTheLift() {
        Scene scene = Scene.lift();
        return Stream.of(
                        scene.with(3, Act.PRESS),
                        scene.with(2, Act.PRESS).with(1, Act.OWN, Act.STOP, Act.FAIL),
                        scene.with(2, Act.PRESS).with(1, Act.GIVE_UP, Act.JUMP, Act.DISMISS),
                        scene.sending().with(2, Act.PRESS).with(1, Act.ASK, Act.END),
                        scene.onFailure(OnFailure.OTHER_WAY).with(2, Act.PRESS).with(1, Act.FAIL, Act.OWN),
                        scene.onFailure(OnFailure.GO_BACK).with(2, Act.PRESS).with(1, Act.FAIL, Act.END),
                        scene.withQueue(0).with(3, Act.PRESS))
                .flatMap(ExplorationTest::bestAndWorst);
    }

    @ParameterizedTest
    @MethodSource("ofTheLift")
    void storiesOfTheLift(Scene scene) {
        explore(scene, 10);
    }

    @ParameterizedTest
    @MethodSource("ofTheLift")
    @Tag("slow")
    void longerStoriesOfTheLift(Scene scene) {
        explore(scene, 14);
    }

    private static void explore(Scene scene, int depth) {
        Exploration.Result result = Exploration.of(scene, Wiring.REAL, depth);
        assertThat(result.violation()).as("%s", scene).isEmpty();
    }
}
