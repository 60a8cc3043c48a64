package org.evoloop.engine;

import static org.evoloop.Machines.machine;

import java.util.Map;
import java.util.stream.Stream;
import org.evoloop.evolution.ModelPair;
import org.evoloop.migration.Mapping;

/** Scenes with new states that need the device somewhere. */
final class DeviceStateScenes {
    private static final String[] DOOR = {
        "Closed press -> Opening",
        "Opening press -> StopUp",
        "Opening limitOpen -> Open",
        "StopUp press -> Closing",
        "Open press -> Closing",
        "Closing press -> StopDown",
        "Closing limitClosed -> Closed",
        "StopDown press -> Opening"
    };

    private static final String[] AIR = {
        "Cool power -> Off",
        "Off power -> Cool",
        "Cool mode -> Dry",
        "Dry mode -> Cool",
        "Dry power -> Off",
        "Cool turbo -> Turbo",
        "Turbo turbo -> Cool",
        "Turbo power -> Off"
    };

    private DeviceStateScenes() {}

    /** A garage door with one button, and a new state in which it is open by a gap. */
    static Scene door() {
        return Scene.of(
                        "door",
                        new ModelPair(
                                machine("door", DOOR),
                                machine(
                                        "door with a gap",
                                        and(
                                                DOOR,
                                                "Closed gap -> GapMoving",
                                                "GapMoving device Opening",
                                                "GapMoving timeout -> Gap",
                                                "Gap device StopUp",
                                                "Gap press -> Closing"))),
                        Map.of("GapMoving", "timeout"),
                        "press",
                        "press",
                        2)
                .pressing("gap");
    }

    /** An air conditioner with a boost, which it leaves for states that take several steps, and with a state that sends. */
    static Scene air() {
        return Scene.of(
                        "air",
                        new ModelPair(
                                machine("air", AIR),
                                machine(
                                        "air with boost",
                                        and(
                                                AIR,
                                                "Cool boost -> Boost",
                                                "Dry boost -> Boost",
                                                "Boost device Turbo",
                                                "Boost timeout -> Cool",
                                                "Boost mode -> Dry",
                                                "Boost boost => Boost",
                                                "Boost turbo -> Hold",
                                                "Hold device Cool",
                                                "Hold power -> Boost",
                                                "Off boost -> Timed",
                                                "Timed sends power",
                                                "Timed boost -> Off"))),
                        Map.of("Boost", "timeout"),
                        "power mode turbo",
                        "power",
                        2)
                .pressing("boost");
    }

    /** A fan with one button, and a boost: the pair of {@code prism/proof/fan}. */
    static Scene fan() {
        String[] fan = {"Off power -> Low", "Low power -> High", "High power -> Off"};
        return Scene.of(
                        "fan",
                        new ModelPair(
                                machine("fan", fan),
                                machine(
                                        "fan with boost",
                                        and(
                                                fan,
                                                "Off boost -> Boost",
                                                "Low boost -> Boost",
                                                "Boost device High",
                                                "Boost timeout -> Low"))),
                        Map.of("Boost", "timeout"),
                        "power",
                        "power",
                        2)
                .pressing("boost");
    }

    /** A fan with a rest, for which the next models need the device off. */
    static Scene restingFan() {
        String[] fan = {"Off power -> Low", "Low power -> High", "High power -> Off"};
        String[] resting = and(fan, "Off rest -> Rest", "Rest rest -> High", "Rest timeout -> Low");
        return resting("resting fan", fan, resting)
                .evolvingTo(resting("fan that rests", fan, and(resting, "Rest device Off")), Mapping.byName());
    }

    /** A fan with a boost wherever it is, for which the next models need it to be high. */
    static Scene boostedFan() {
        String[] fan = {"Off power -> Low", "Low power -> High", "High power -> Off"};
        String[] boosted = and(fan, "Off rest -> Rest", "Rest rest -> Off", "Rest timeout -> Low");
        return resting("boosted fan", fan, boosted)
                .evolvingTo(resting("high fan", fan, and(boosted, "Rest device High")), Mapping.byName());
    }

    private static Scene resting(String name, String[] device, String[] evolved) {
        ModelPair pair = new ModelPair(machine("fan", device), machine(name, evolved));
        return Scene.of(name, pair, Map.of("Rest", "timeout"), "power", "", 2).pressing("rest");
    }

    private static String[] and(String[] some, String... more) {
        return Stream.concat(Stream.of(some), Stream.of(more)).toArray(String[]::new);
    }
}
