package org.evoloop;

import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAnyPackage;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaCodeUnit;
import com.tngtech.archunit.core.domain.JavaField;
import com.tngtech.archunit.core.domain.JavaModifier;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchCondition;
import com.tngtech.archunit.lang.ArchRule;
import com.tngtech.archunit.lang.ConditionEvents;
import com.tngtech.archunit.lang.SimpleConditionEvent;
import com.tngtech.archunit.library.Architectures;
import com.tngtech.archunit.library.dependencies.SliceAssignment;
import com.tngtech.archunit.library.dependencies.SliceIdentifier;
import com.tngtech.archunit.library.dependencies.SlicesRuleDefinition;
import java.time.Clock;
import java.time.Instant;
import java.time.LocalDate;
import java.time.LocalDateTime;
import java.time.LocalTime;
import java.time.ZonedDateTime;
import java.util.Random;
import java.util.Timer;
import java.util.UUID;
import java.util.stream.Stream;
import org.evoloop.loop.Component;

/**
 * The packages of the core module and the dependencies allowed between them; those between modules are in module-info.
 */
@AnalyzeClasses(packages = "org.evoloop", importOptions = ImportOption.DoNotIncludeTests.class)
class ArchitectureTest {
    private static final String CONVERTER = "org.evoloop.converter..";

    @ArchTest
    static final ArchRule arrowsRunDown = Architectures.layeredArchitecture()
            .consideringOnlyDependenciesInLayers()
            .layer("statemachine")
            .definedBy("org.evoloop.statemachine..")
            .layer("time")
            .definedBy("org.evoloop.time..")
            .layer("flight")
            .definedBy("org.evoloop.flight..")
            .layer("evolution")
            .definedBy("org.evoloop.evolution..")
            .layer("migration")
            .definedBy("org.evoloop.migration..")
            .layer("engine")
            .definedBy("org.evoloop.engine..")
            .layer("loop")
            .definedBy("org.evoloop.loop..")
            .layer("function")
            .definedBy("org.evoloop.function..")
            .layer("rehearsal")
            .definedBy("org.evoloop.rehearsal..")
            .layer("binding")
            .definedBy("org.evoloop.converter.binding..")
            .layer("attachment")
            .definedBy("org.evoloop.converter.attachment..")
            .layer("converter")
            .definedBy("org.evoloop.converter")
            .layer("recording")
            .definedBy("org.evoloop.converter.recording..")
            .layer("running")
            .definedBy("org.evoloop.converter.running..")
            .layer("changing")
            .definedBy("org.evoloop.converter.changing..")
            .layer("edge")
            .definedBy("org.evoloop.converter.edge..")
            .whereLayer("statemachine")
            .mayNotAccessAnyLayer()
            .whereLayer("time")
            .mayNotAccessAnyLayer()
            .whereLayer("flight")
            .mayNotAccessAnyLayer()
            .whereLayer("evolution")
            .mayOnlyAccessLayers("statemachine")
            .whereLayer("migration")
            .mayOnlyAccessLayers("evolution", "statemachine")
            .whereLayer("engine")
            .mayOnlyAccessLayers("migration", "evolution", "statemachine")
            .whereLayer("loop")
            .mayOnlyAccessLayers("time", "flight")
            .whereLayer("function")
            .mayOnlyAccessLayers("evolution", "loop", "time", "statemachine")
            .whereLayer("rehearsal")
            .mayOnlyAccessLayers("engine", "evolution", "statemachine")
            .whereLayer("binding")
            .mayOnlyAccessLayers("loop", "evolution", "time", "statemachine")
            .whereLayer("attachment")
            .mayOnlyAccessLayers("binding", "loop", "function", "evolution", "statemachine")
            .whereLayer("converter")
            .mayOnlyAccessLayers(
                    "attachment",
                    "binding",
                    "engine",
                    "rehearsal",
                    "migration",
                    "loop",
                    "function",
                    "evolution",
                    "time",
                    "statemachine")
            .whereLayer("recording")
            .mayOnlyAccessLayers(
                    "converter", "attachment", "engine", "loop", "flight", "evolution", "time", "statemachine")
            .whereLayer("running")
            .mayOnlyAccessLayers(
                    "recording",
                    "converter",
                    "attachment",
                    "binding",
                    "engine",
                    "rehearsal",
                    "migration",
                    "loop",
                    "function",
                    "flight",
                    "evolution",
                    "time",
                    "statemachine")
            .whereLayer("changing")
            .mayOnlyAccessLayers(
                    "running",
                    "recording",
                    "converter",
                    "attachment",
                    "engine",
                    "migration",
                    "loop",
                    "evolution",
                    "time",
                    "statemachine")
            .whereLayer("edge")
            .mayOnlyAccessLayers(
                    "running",
                    "recording",
                    "converter",
                    "attachment",
                    "binding",
                    "engine",
                    "loop",
                    "evolution",
                    "statemachine");

    @ArchTest
    static final ArchRule noRoomsLeadInACircle =
            SlicesRuleDefinition.slices().matching("org.evoloop.(**)").should().beFreeOfCycles();

    /** The packages that no module exports. */
    private static final String[] HIDDEN = {
        "org.evoloop.converter.attachment",
        "org.evoloop.converter.binding",
        "org.evoloop.converter.recording",
        "org.evoloop.converter.running",
        "org.evoloop.converter.changing",
        "org.evoloop.function.visit",
        "org.evoloop.flight"
    };

    @ArchTest
    static final ArchRule usersCanNameWhatTheyCallAndGetBack =
            classes().that().arePublic().and().resideOutsideOfPackages(HIDDEN).should(offerNothingHidden());

    private static ArchCondition<JavaClass> offerNothingHidden() {
        return new ArchCondition<>("offer nothing whose types are hidden") {
            @Override
            public void check(JavaClass item, ConditionEvents events) {
                for (JavaCodeUnit each : item.getCodeUnits()) {
                    boolean offered = each.getModifiers().contains(JavaModifier.PUBLIC)
                            || each.getModifiers().contains(JavaModifier.PROTECTED);
                    boolean hidden = Stream.concat(
                                    each.getRawParameterTypes().stream(), Stream.of(each.getRawReturnType()))
                            .anyMatch(resideInAnyPackage(HIDDEN));
                    events.add(new SimpleConditionEvent(
                            each, !offered || !hidden, each.getFullName() + " has a hidden type"));
                }
            }
        };
    }

    /** Whoever reads a file of these rooms need not have read another one that needs this one. */
    @ArchTest
    static final ArchRule noFilesLeadInACircle = SlicesRuleDefinition.slices()
            .assignedFrom(new FilesOfTheLoopAndTheConverter())
            .should()
            .beFreeOfCycles();

    private static final class FilesOfTheLoopAndTheConverter implements SliceAssignment {
        @Override
        public SliceIdentifier getIdentifierOf(JavaClass item) {
            if (!resideInAnyPackage("org.evoloop.loop", CONVERTER).test(item)) {
                return SliceIdentifier.ignore();
            }
            JavaClass file = item;
            while (file.getEnclosingClass().isPresent()) {
                file = file.getEnclosingClass().get();
            }
            // A sealed class and those that it permits name each other.
            boolean sealed = file.getPackageName().equals("org.evoloop.loop") && file.isAssignableTo(Component.class);
            return SliceIdentifier.of(sealed ? Component.class.getName() : file.getName());
        }

        @Override
        public String getDescription() {
            return "files of the loop and the converter";
        }
    }

    @ArchTest
    static final ArchRule threadsBeginInTheirRooms = noClasses()
            .that()
            .resideOutsideOfPackages("org.evoloop.loop..", "org.evoloop.time..", "org.evoloop.function..", CONVERTER)
            .should()
            .dependOnClassesThat()
            .areAssignableTo(Thread.class)
            .orShould()
            .dependOnClassesThat()
            .resideInAPackage("java.util.concurrent..");

    @ArchTest
    static final ArchRule decisionsArePure = noClasses()
            .that(resideInAnyPackage(
                    "org.evoloop.statemachine..", "org.evoloop.evolution..", "org.evoloop.migration.."))
            .should()
            .dependOnClassesThat()
            .resideInAnyPackage("java.io..", "java.nio..", "java.net..", "org.slf4j..")
            .orShould()
            .dependOnClassesThat()
            .areAssignableTo(Thread.class);

    /**
     * The same inputs give the same outputs: nothing in it waits, reads a clock, uses random numbers or notifies
     * anyone.
     */
    @ArchTest
    static final ArchRule theCoreIsDeterministic = noClasses()
            .that(resideInAPackage("org.evoloop.engine.."))
            .should()
            .dependOnClassesThat()
            .resideInAnyPackage(
                    "java.util.concurrent..",
                    "java.io..",
                    "java.nio..",
                    "java.net..",
                    "java.util.random..",
                    "java.lang.ref..",
                    "org.slf4j..")
            .orShould()
            .dependOnClassesThat()
            .belongToAnyOf(
                    Thread.class,
                    ThreadLocal.class,
                    Timer.class,
                    Random.class,
                    UUID.class,
                    Clock.class,
                    Instant.class,
                    LocalDate.class,
                    LocalTime.class,
                    LocalDateTime.class,
                    ZonedDateTime.class)
            .orShould()
            .callMethod(System.class, "nanoTime")
            .orShould()
            .callMethod(Math.class, "random")
            .orShould()
            .callMethod(System.class, "identityHashCode", Object.class)
            .orShould(haveStaticState());

    /** With static state, two cores in one process would affect each other. */
    private static ArchCondition<JavaClass> haveStaticState() {
        return new ArchCondition<>("have static fields that are not final") {
            @Override
            public void check(JavaClass item, ConditionEvents events) {
                for (JavaField field : item.getFields()) {
                    boolean constant = field.getModifiers().contains(JavaModifier.FINAL);
                    boolean shared = field.getModifiers().contains(JavaModifier.STATIC) && !constant;
                    events.add(new SimpleConditionEvent(field, shared, field.getFullName() + " is static, not final"));
                }
            }
        };
    }

    /** How long a thread really waits is not the converter's time, so it belongs to the loop's own package. */
    @ArchTest
    static final ArchRule timeIsInjected = noClasses()
            .that(resideInAPackage("org.evoloop..")
                    .and(com.tngtech.archunit.base.DescribedPredicate.not(resideInAPackage("org.evoloop.time.."))))
            .should()
            .callMethod(System.class, "currentTimeMillis")
            .orShould()
            .callMethod(Thread.class, "sleep", long.class)
            .orShould()
            .callMethod(java.time.Instant.class, "now");

    @ArchTest
    static final ArchRule onlyTheLoopAndTheClockLookAtTheMachinesTime = noClasses()
            .that()
            .resideOutsideOfPackages("org.evoloop.time..", "org.evoloop.loop..")
            .should()
            .callMethod(System.class, "nanoTime");

    @ArchTest
    static final ArchRule nothingIsPrinted =
            noClasses().should().accessField(System.class, "out").orShould().accessField(System.class, "err");
}
