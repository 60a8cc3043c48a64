package org.evoloop.roomba;

import static com.tngtech.archunit.base.DescribedPredicate.not;
import static com.tngtech.archunit.base.DescribedPredicate.or;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAnyPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.type;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;
import org.evoloop.link.LinkException;
import org.evoloop.roomba.simulator.SimulatorCommand;

/**
 * The packages of the application, and rules for all modules of the Roomba; dependencies between modules are in
 * module-info.
 */
@AnalyzeClasses(packages = "org.evoloop.roomba", importOptions = ImportOption.DoNotIncludeTests.class)
class ArchitectureTest {
    private static final String APPLICATION = "org.evoloop.roomba";
    private static final String OI = "org.evoloop.roomba.oi..";
    private static final String SESSION = "org.evoloop.roomba.session..";
    private static final String CAMERA = "org.evoloop.roomba.camera..";
    private static final String MOVE = "org.evoloop.roomba.move..";
    private static final String TIME = "org.evoloop.time..";

    private static ArchRule room(String room, DescribedPredicate<JavaClass> mayUse) {
        return classes()
                .that()
                .resideInAPackage(room)
                .should()
                .onlyDependOnClassesThat(or(resideInAPackage(room), mayUse, not(resideInAPackage("org.evoloop.."))));
    }

    @ArchTest
    static final ArchRule moveSeesTheRobotThroughItsSession = room(
            MOVE,
            or(
                    resideInAnyPackage(
                            OI,
                            SESSION,
                            CAMERA,
                            TIME,
                            "org.evoloop.loop..",
                            "org.evoloop.function..",
                            "org.evoloop.statemachine.."),
                    type(LinkException.class)));

    @ArchTest
    static final ArchRule whatMoveDoesNextIsPure = room(
            "org.evoloop.roomba.move.phase..",
            resideInAnyPackage(OI, "org.evoloop.roomba.session", "org.evoloop.roomba.session.inference"));

    @ArchTest
    static final ArchRule nothingUsesTheApplication = noClasses()
            .that()
            .resideOutsideOfPackage(APPLICATION)
            .should()
            .dependOnClassesThat()
            .resideInAPackage(APPLICATION);

    @ArchTest
    static final ArchRule resultsArePrintedByTheCommandsOnly = noClasses()
            .that()
            .resideOutsideOfPackage(APPLICATION)
            .and()
            .doNotBelongToAnyOf(SimulatorCommand.class)
            .should()
            .accessField(System.class, "out")
            .orShould()
            .accessField(System.class, "err");

    @ArchTest
    static final ArchRule timeIsInjected = noClasses()
            .should()
            .callMethod(Thread.class, "sleep", long.class)
            .orShould()
            .callMethod(System.class, "currentTimeMillis")
            .orShould()
            .callMethod(java.time.Instant.class, "now");
}
