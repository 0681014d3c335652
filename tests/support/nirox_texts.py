"""A small NIROX file written by hand: two links, masses, a DC motor with a gear, and an ideal motor."""

HEAD = """ISO-10303-21;
HEADER;
FILE_DESCRIPTION(('two links'),'2;1');
FILE_NAME('two_links.stp','2026-01-01T00:00:00',(''),(''),'','','');
FILE_SCHEMA(('ROPSIM_NIROX_V1'));
ENDSEC;
DATA;
"""
END = "ENDSEC;\nEND-ISO-10303-21;\n"

DATA = """/* units: each link has a context of its own */
#1=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT($,.METRE.));
#2=(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.));
#3=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((#1,#2))REPRESENTATION_CONTEXT('base',''));
#4=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((#1,#2))REPRESENTATION_CONTEXT('arm',''));
#5=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((#1,#2))REPRESENTATION_CONTEXT('hand',''));
#6=REPRESENTATION_CONTEXT('topology','');
/* links and joints */
#10=KINEMATIC_LINK('base');
#11=KINEMATIC_LINK('arm');
#12=KINEMATIC_LINK('hand');
#20=KINEMATIC_JOINT('1',#10,#11);
#21=KINEMATIC_JOINT('2',#11,#12);
#25=KINEMATIC_TOPOLOGY_STRUCTURE('two links',(#20,#21),#6);
/* where the pairs are on the links */
#30=CARTESIAN_POINT('',(0.,0.,0.));
#31=CARTESIAN_POINT('',(0.5,0.,0.));
#32=CARTESIAN_POINT('',(0.3,0.,0.));
#33=DIRECTION('',(0.,0.,1.));
#34=DIRECTION('',(1.,0.,0.));
#40=AXIS2_PLACEMENT_3D('',#30,#33,#34);
#41=AXIS2_PLACEMENT_3D('',#31,$,$);
#42=AXIS2_PLACEMENT_3D('',#32,$,$);
#43=AXIS2_PLACEMENT_3D('',#30,$,$);
#44=AXIS2_PLACEMENT_3D('',#30,$,$);
#50=RIGID_LINK_REPRESENTATION('base',(#40),#3,#10);
#51=RIGID_LINK_REPRESENTATION('arm',(#41,#43),#4,#11);
#52=RIGID_LINK_REPRESENTATION('hand',(#42,#44),#5,#12);
#60=REVOLUTE_PAIR_WITH_RANGE('1',*,$,#40,#43,#20,*,*,*,*,*,*,-3.,3.);
#61=REVOLUTE_PAIR_WITH_RANGE('2',*,$,#41,#44,#21,*,*,*,*,*,*,-2.5,2.5);
#70=PAIR_REPRESENTATION_RELATIONSHIP('1','',$,#50,#51,#60);
#71=PAIR_REPRESENTATION_RELATIONSHIP('2','',$,#51,#52,#61);
#80=MECHANISM_REPRESENTATION('two links',(#70,#71),#3,#25);
#90=REVOLUTE_PAIR_VALUE('1',#60,0.3);
#91=REVOLUTE_PAIR_VALUE('2',#61,-0.6);
#95=MECHANISM_STATE_REPRESENTATION('home',(#90,#91),*,#80);
/* what NIROX adds */
#100=ROBOT_ARM('two_links','Example','Two links',#80,#10,(#60,#61),(#101),(0.,0.,-9.81),#95);
#101=ROBOT_FRAME('flange',.MECHANICAL_INTERFACE.,#12,#42);
#110=RIGID_LINK_MASS_PROPERTIES(#11,4.,(0.25,0.,0.),(0.004,0.09,0.09,0.,0.,0.),.CAD.);
#111=RIGID_LINK_MASS_PROPERTIES(#12,2.,(0.15,0.,0.),(0.002,0.02,0.02,0.,0.,0.),.ESTIMATED.);
#120=DC_SERVO_MOTOR('m1',0.1,0.1,1.,0.001,0.0001,48.,10.,$,$,$);
#121=GEAR_TRANSMISSION('g1',100.,1.,0.,$,$,0.);
#122=DRIVE_TRAIN('d1',#60,#120,#121,$,3.,30.,300.,());
#123=COULOMB_VISCOUS_FRICTION(#60,.MOTOR_SIDE.,0.0001,0.02,$);
#130=IDEAL_EFFORT_SOURCE('m2',20.,$);
#131=GEAR_TRANSMISSION('g2',1.,1.,0.,$,$,0.);
#132=DRIVE_TRAIN('d2',#61,#130,#131,$,4.,40.,400.,());
#140=PARAMETER_ORIGIN(#100,'all numbers',$,'estimated: round numbers');
"""

TEXT = HEAD + DATA + END


def line_of(number: int, text: str = TEXT) -> int:
    """Return the line, from 1, where an instance stands."""
    return next(k for k, line in enumerate(text.splitlines(), 1) if line.startswith(f"#{number}="))
